// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/date_text.h"
#include "ui/pages/calibrate/calibrate_taking.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/quantity_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QGridLayout>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr std::pair<double, double> tolerances_N{1e-3, 1000}, tolerances_m{1e-7, 0.1};
constexpr double leastTolerance_N = 1e-3, leastTolerance_m = 1e-7;

QuantityBox* makeTolerance(SensorChannel channel, QWidget* parent)
{
    return channel == SensorChannel::Force
               ? new QuantityBox(fieldUnit(MechanicalQuantity::Force), tolerances_N, leastTolerance_N, parent)
               : new QuantityBox(fieldUnit(MechanicalQuantity::Length), tolerances_m, leastTolerance_m,
                                 parent);
}

const RegisteredDialog<CertificateDialog> certificateDialogRow("certificate", [](Workbench&, QWidget* over) {
    return new CertificateDialog({}, SensorChannel::Force, over);
});
} // namespace

CertificateDialog::CertificateDialog(const CertificateDetails& details, SensorChannel channel,
                                     QWidget* parent)
    : Dialog(parent), m_hasDue(new QCheckBox(tr("The reference's certificate holds until"), this)),
      m_hasAmbient(new QCheckBox(tr("Ambient temperature"), this)),
      m_hasTolerance(new QCheckBox(tr("Tolerance"), this)),
      m_checkAfter(new QCheckBox(tr("Go through the loads once more at the end, as a check"), this)),
      m_due(new QDateEdit(this)), m_ambient(new QDoubleSpinBox(this)),
      m_tolerance(makeTolerance(channel, this)), m_rule(new QComboBox(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("certificateDialog");
    setManualPage(u"calibrate"_s);
    setWindowTitle(tr("For the certificate"));
    build();
    show(details);
}

void CertificateDialog::build()
{
    m_due->setCalendarPopup(true);
    m_due->setDisplayFormat(dateFormat.toString());
    m_due->setObjectName("certificateReferenceDue");
    m_ambient->setRange(leastAmbient_C, mostAmbient_C);
    m_ambient->setDecimals(1);
    m_ambient->setSuffix(QChar(QChar::Nbsp) + u"°C"_s);
    m_ambient->setObjectName("certificateAmbient");
    m_tolerance->setPrefix(u"± "_s);
    m_tolerance->setObjectName("certificateTolerance");
    m_hasDue->setObjectName("certificateHasReferenceDue");
    m_hasAmbient->setObjectName("certificateHasAmbient");
    m_hasTolerance->setObjectName("certificateHasTolerance");
    m_checkAfter->setObjectName("certificateCheckAfter");
    m_rule->setObjectName("certificateRule");
    m_rule->addItem(tr("conforms with the uncertainty counted"), int(DecisionRule::Guarded));
    m_rule->addItem(tr("conforms by the error alone"), int(DecisionRule::Simple));

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(8);
    grid->setColumnStretch(1, 1);
    addRow(grid, m_hasDue, m_due);
    addRow(grid, m_hasAmbient, m_ambient);
    addRow(grid, m_hasTolerance, m_tolerance);
    auto* ruleName = makeLabel(tr("Decision rule"), "strong", this);
    ruleName->setBuddy(m_rule);
    m_rule->setAccessibleName(ruleName->text());
    grid->addWidget(ruleName, grid->rowCount(), 0);
    grid->addWidget(m_rule, grid->rowCount() - 1, 1);
    m_rule->setEnabled(false);
    connect(m_hasTolerance, &QCheckBox::toggled, m_rule, &QWidget::setEnabled);

    auto* cancel = makeButton(tr("Cancel"), {}, "", this);
    auto* keep = makeButton(tr("Keep"), u"dialog-ok-apply"_s, "primary", this);
    keep->setObjectName("certificateKeep");
    keep->setDefault(true);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(keep, &QPushButton::clicked, this, &QDialog::accept);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(keep);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 16);
    column->addLayout(grid);
    column->addWidget(m_checkAfter);
    column->addStretch(1);
    column->addLayout(buttons);
    resize(640, 380);
}

void CertificateDialog::addRow(QGridLayout* grid, QCheckBox* stated, QWidget* field)
{
    const int row = grid->rowCount();
    grid->addWidget(stated, row, 0);
    grid->addWidget(field, row, 1);
    field->setAccessibleName(stated->text());
    field->setEnabled(false);
    connect(stated, &QCheckBox::toggled, field, &QWidget::setEnabled);
}

void CertificateDialog::show(const CertificateDetails& details)
{
    constexpr double usual_C = 20;
    m_hasDue->setChecked(details.referenceDue.isValid());
    m_due->setDate(details.referenceDue.isValid() ? details.referenceDue : QDate::currentDate().addYears(1));
    m_hasAmbient->setChecked(details.ambient_C.has_value());
    m_ambient->setValue(details.ambient_C.value_or(usual_C));
    m_hasTolerance->setChecked(details.tolerance_si.has_value());
    if (details.tolerance_si)
        m_tolerance->setSi(*details.tolerance_si);
    m_rule->setCurrentIndex(m_rule->findData(int(details.rule)));
    m_checkAfter->setChecked(details.checkAfter);
}

CertificateDetails CertificateDialog::details() const
{
    CertificateDetails details;
    if (m_hasDue->isChecked())
        details.referenceDue = m_due->date();
    if (m_hasAmbient->isChecked())
        details.ambient_C = m_ambient->value();
    if (m_hasTolerance->isChecked())
        details.tolerance_si = m_tolerance->si();
    details.rule = DecisionRule(m_rule->currentData().toInt());
    details.checkAfter = m_checkAfter->isChecked();
    return details;
}

} // namespace gripscope
