// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/library/library.h"

#include <QWidget>

class QLabel;

namespace gripscope {

class QuantityBox;
class Workbench;

/// The fields of a recipe with their units. It says what the forces will be, and what is wrong with them
/// before anything is sent: above the crush limit, above the gripper's own, or a pull.
class EnrollRecipeForm : public QWidget {
    Q_OBJECT
public:
    explicit EnrollRecipeForm(Workbench& workbench, QWidget* parent = nullptr);
    void setRecipe(const Recipe& recipe, bool readOnly);
    [[nodiscard]] Recipe recipe() const;
    [[nodiscard]] bool isValid() const { return m_valid; }

signals:
    void changed();

private:
    QuantityBox* makeField(const QString& name, const ShownUnit& unit, std::pair<double, double> range_si,
                           double resolution_si);
    void validate();
    [[nodiscard]] QString problem(const Recipe& recipe) const;
    Workbench* m_workbench;
    QuantityBox *m_peak, *m_bias, *m_bit, *m_seconds, *m_maxForce, *m_maxTravel;
    QLabel* m_summary;
    bool m_valid = true;
    QString m_name;
};

} // namespace gripscope
