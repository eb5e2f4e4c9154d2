// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "ui/windows/dialog.h"

#include <QTimer>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gripscope {

class LimitFields;
class Workbench;

/// What m, b and k of the parts of a type may be, by which rule that is decided, and what such limits risk by
/// the squeezes of that type which are there. Changed as the other properties of types: with a reason, by who
/// may change types.
class TypeLimitsDialog : public Dialog {
    Q_OBJECT
public:
    /// `type`: shown first, by name; empty: the first one.
    explicit TypeLimitsDialog(Workbench& workbench, const QString& type = {}, QWidget* parent = nullptr);

private:
    void build();
    void load(const QString& type);
    void showTypes(std::vector<TypeRecord> types, const QString& first);
    void showType();
    void refresh();
    void tellProblem(const QString& problem);
    void askRisks();
    void showRisks(const PartLimits& limits, const LimitRisks& risks);
    void keep();
    [[nodiscard]] const TypeRecord* type() const;
    /// As typed; nothing, with what is wrong in `problem`.
    [[nodiscard]] std::optional<PartLimits> wanted(QString& problem) const;

    Workbench* m_workbench;
    std::vector<TypeRecord> m_listed; ///< those in use
    std::vector<MeasuredValues> m_measured;
    int m_asked = 0; ///< answers to older questions are dropped
    QTimer m_soon;
    QComboBox *m_type, *m_rule;
    LimitFields* m_fields;
    QDoubleSpinBox* m_risk;
    QLabel *m_risks, *m_problem;
    QLineEdit* m_reason;
    QPushButton* m_keep;
};

} // namespace gripscope
