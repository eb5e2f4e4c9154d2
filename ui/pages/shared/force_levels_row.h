// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/squeeze/recipe_design.h"

#include <QWidget>

#include <functional>

class QLabel;
class QPushButton;

namespace gripscope {

class Workbench;

/// Where a force of levels comes from: a file, or the designer, for the types that are enrolled. Both are
/// worked out in the pool.
class ForceLevelsRow : public QWidget {
    Q_OBJECT
public:
    explicit ForceLevelsRow(Workbench& workbench, QWidget* parent = nullptr);
    /// What the designer keeps to when it is asked.
    void setAllowed(std::function<Recipe()> recipe, std::function<GripperIdentity()> gripper);
    /// Says what there is.
    void show(const Recipe& recipe);
    void open(const QString& file); ///< a force in a file

signals:
    void read(const gripscope::ForceLevels& force);     ///< from a file: all of the recipe's force
    void designed(const gripscope::ForceLevels& force); ///< within what the recipe allows

private:
    void chooseFile();
    void design();
    void take(const Expected<ForceLevels>& force, void (ForceLevelsRow::*tell)(const ForceLevels&));

    Workbench* m_workbench;
    QPushButton *m_file, *m_design;
    QLabel* m_says;
    std::function<Recipe()> m_recipe;
    std::function<GripperIdentity()> m_gripper;
};

} // namespace gripscope
