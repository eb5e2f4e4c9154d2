// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/squeeze/recipe_expectation.h"

#include <QLabel>

namespace gripscope {

class Workbench;

/// One sentence on what a squeeze can tell at best of a part like a drinks can, by model: "m ±0.5 %...".
/// Found in the pool; while a recipe changes only the latest one counts.
class ExpectationView : public QLabel {
    Q_OBJECT
public:
    explicit ExpectationView(Workbench& workbench, QWidget* parent = nullptr);
    /// Without a gripper that can squeeze by it, `recipe` is one that says nothing: the sentence goes.
    void show(const Recipe& recipe, const GripperIdentity& identity);

signals:
    void shown(); ///< the sentence is that of the latest recipe

private:
    void begin();
    void tell(const std::vector<ModelExpectation>& models);

    Workbench* m_workbench;
    Recipe m_recipe;
    GripperIdentity m_identity;
    bool m_busy = false, m_changed = false;
};

} // namespace gripscope
