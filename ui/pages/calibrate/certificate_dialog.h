// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_plan.h"
#include "ui/windows/dialog.h"

class QCheckBox;
class QComboBox;
class QDateEdit;
class QDoubleSpinBox;
class QGridLayout;

namespace gripscope {

class QuantityBox;

/// What a certificate says that the points do not.
struct CertificateDetails {
    QDate referenceDue; ///< invalid: nobody said
    std::optional<double> ambient_C;
    std::optional<double> tolerance_si;
    DecisionRule rule = DecisionRule::Guarded;
    bool checkAfter = false;
};

/// Asks for it before the first load is put on. What is not ticked is not stated.
class CertificateDialog : public Dialog {
    Q_OBJECT
public:
    CertificateDialog(const CertificateDetails& details, SensorChannel channel, QWidget* parent = nullptr);
    [[nodiscard]] CertificateDetails details() const;

private:
    void build();
    void addRow(QGridLayout* grid, QCheckBox* stated, QWidget* field);
    void show(const CertificateDetails& details);

    QCheckBox *m_hasDue, *m_hasAmbient, *m_hasTolerance, *m_checkAfter;
    QDateEdit* m_due;
    QDoubleSpinBox* m_ambient;
    QuantityBox* m_tolerance;
    QComboBox* m_rule;
};

} // namespace gripscope
