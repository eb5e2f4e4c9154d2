// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/library/library.h"
#include "core/session/squeeze/recipe_design.h"

#include <QLabel>
#include <QWidget>

#include <functional>
#include <vector>

class QComboBox;
class QPushButton;

namespace gripscope {

class QuantityBox;
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

/// The force of a squeeze as it will go, between zero and the crush limit: how far, how fast, on how many
/// levels. A look, without numbers of its own.
class ForcePicture : public QWidget {
    Q_OBJECT
public:
    explicit ForcePicture(QWidget* parent = nullptr);
    /// In the order of time, at equal steps; none: an empty frame.
    void show(std::vector<double> force_N, double limit_N);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<double> m_force_N;
    double m_limit_N = 0;
};

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
