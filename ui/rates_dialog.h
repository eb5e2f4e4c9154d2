// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict.h"

#include <QDialog>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QRadioButton;

namespace gripscope {

/// The rates verdicts are held to, each with what it counts, and whether a squeeze may end early.
class RatesDialog : public QDialog {
    Q_OBJECT
public:
    RatesDialog(const VerdictOptions& rates, bool earlyEnd, QWidget* parent = nullptr);
    [[nodiscard]] VerdictOptions rates() const; ///< as they stand in the fields
    [[nodiscard]] bool earlyEnd() const;

private:
    QDoubleSpinBox* addRate(QFormLayout* form, const QString& name, const QString& meaning);
    void build();
    void fill(const VerdictOptions& rates, bool earlyEnd);
    VerdictOptions m_rates; ///< what has no field stays as it was
    QDoubleSpinBox *m_falseReject = nullptr, *m_wrongType = nullptr, *m_strangerAccept = nullptr;
    QRadioButton *m_average = nullptr, *m_confident = nullptr;
    QCheckBox *m_robust = nullptr, *m_early = nullptr;
};

} // namespace gripscope
