// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/session/quality/study_session.h"

#include <QWidget>

#include <array>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace gripscope {

class QuantityBox;
class Workbench;

/// What a study is to be, before its first squeeze. It says what is missing, and how many squeezes it takes.
class StudyForm : public QWidget {
    Q_OBJECT
public:
    explicit StudyForm(Workbench& workbench, QWidget* parent = nullptr);
    void begin(StudyKind kind, const QString& name); ///< with what is usual for that kind
    [[nodiscard]] StudyRequest request() const;
    void focusField();
    void submit(); ///< as Enter does

signals:
    void submitted(const gripscope::StudyRequest& request);
    void cancelled();

private:
    void build();
    void addFields(QFormLayout* form);
    [[nodiscard]] QWidget* makeTolerances();
    [[nodiscard]] QWidget* makeButtons();
    void showRow(QWidget* field, bool on);
    void fillRecipes();
    void askForReferences();
    [[nodiscard]] ShownUnit referenceUnit() const; ///< in which references are typed
    void refresh();
    [[nodiscard]] PlanDesign design() const;
    [[nodiscard]] QString problem() const;

    Workbench* m_workbench;
    StudyKind m_kind = StudyKind::Gauge;
    std::uint64_t m_seed = 1; ///< of the order; nobody is shown it
    QFormLayout* m_form;
    QLabel *m_title, *m_answer, *m_hint;
    QLineEdit *m_name, *m_labels, *m_operators, *m_references;
    QSpinBox *m_parts, *m_trials;
    QComboBox *m_order, *m_quantity, *m_recipe;
    QWidget* m_tolerances;
    std::array<QuantityBox*, 3> m_tolerance{}; ///< m, b, k; 0: not stated
    QPushButton *m_back = nullptr, *m_begin = nullptr;
    std::vector<Recipe> m_recipes;
};

} // namespace gripscope
