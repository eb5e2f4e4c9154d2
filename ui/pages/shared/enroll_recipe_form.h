// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/library/library.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;

namespace gripscope {

class ExpectationView;
class ForceLevelsRow;
class ForcePicture;
class QuantityBox;
class Workbench;
struct ForceLevels;
struct GripperIdentity;

/// The fields of a recipe with their units. It says what the forces will be, and what is wrong with them
/// before anything is sent, and shows them: above the crush limit, above the gripper's own, or a pull.
class EnrollRecipeForm : public QWidget {
    Q_OBJECT
public:
    /// What is between the fingers: of nothing there is nothing to be expected.
    enum class Gripped { Part, Nothing };

    EnrollRecipeForm(Workbench& workbench, Gripped gripped, QWidget* parent = nullptr);
    void setRecipe(const Recipe& recipe, bool readOnly);
    [[nodiscard]] Recipe recipe() const;
    [[nodiscard]] bool isValid() const { return m_valid; }

signals:
    void changed();

private:
    QuantityBox* makeField(const QString& name, const ShownUnit& unit, std::pair<double, double> range_si,
                           double resolution_si);
    void makeKind();
    void makeLevels();
    /// The levels, and how long each is; what else the recipe has stays.
    void takeLevels(const ForceLevels& force);
    void takeFile(const ForceLevels& force); ///< all of it
    void validate();
    /// The first second of it.
    void showForce(const Recipe& wanted);
    [[nodiscard]] ExcitationKind kind() const;
    /// The one that is connected; else one that samples as most do.
    [[nodiscard]] GripperIdentity gripper() const;
    [[nodiscard]] QString problem(const Recipe& recipe) const;
    Workbench* m_workbench;
    QuantityBox *m_peak, *m_bias, *m_bit, *m_seconds, *m_maxForce, *m_maxTravel;
    QComboBox* m_kind;
    ForceLevelsRow* m_levelsRow;
    ForcePicture* m_picture;
    QLabel* m_summary;
    ExpectationView* m_expectation = nullptr; ///< of a part
    bool m_valid = true;
    QString m_name;
    std::vector<double> m_levels; ///< of a force that somebody has
};

} // namespace gripscope
