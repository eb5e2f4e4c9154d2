// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/units.h"
#include "ui/context/workbench.h"
#include "ui/format/calibration_words.h"
#include "ui/pages/calibrate/calibrate_taking.h"
#include "ui/pages/page_state.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/quantity_box.h"
#include "ui/widgets/quantity_list_edit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

/// The largest of 1, 2, 5, 10, ... that is not above `most`.
double roundBelow(double most)
{
    constexpr double slack = 1e-9; // of the factors
    const double decade = std::pow(10.0, std::floor(std::log10(most) + slack));
    for (const double digit : {5.0, 2.0})
        if (digit * decade <= most * (1 + slack))
            return digit * decade;
    return decade;
}

constexpr std::pair<double, double> uncertainties_N{0, 1000}, uncertainties_m{0, 1};
constexpr double leastUncertainty_N = 1e-6, leastUncertainty_m = 1e-9;

} // namespace

CalibrateSetup::CalibrateSetup(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_channel(new QComboBox(this)),
      m_loads(new QuantityListEdit(this)), m_runs(new QSpinBox(this)),
      m_descending(new QCheckBox(tr("and down"), this)), m_degree(new QSpinBox(this)),
      m_reference(new QLineEdit(this)), m_certificate(new QLineEdit(this)),
      m_uncertainty(new QuantityBox({}, uncertainties_N, leastUncertainty_N, this)),
      m_summary(makeLabel({}, "second", this)),
      m_begin(makeButton(tr("Begin"), u"media-playback-start"_s, "primary", this))
{
    build();
    connect(m_channel, &QComboBox::currentIndexChanged, this, &CalibrateSetup::proposeLoads);
    for (QLineEdit* field : {static_cast<QLineEdit*>(m_loads), m_reference, m_certificate})
        connect(field, &QLineEdit::textChanged, this, &CalibrateSetup::validate);
    for (QSpinBox* field : {m_runs, m_degree})
        connect(field, &QSpinBox::valueChanged, this, &CalibrateSetup::validate);
    connect(m_uncertainty, &QDoubleSpinBox::valueChanged, this, &CalibrateSetup::validate);
    connect(m_descending, &QCheckBox::toggled, this, &CalibrateSetup::validate);
    connect(&workbench, &Workbench::connectionChanged, this, &CalibrateSetup::validate);
    connect(&workbench.settings(), &Settings::changed, this, [this](const QString& key) {
        if (key == QLatin1String(setting::gravity.key) && loadUnit() != LoadUnit::Channel)
            takeGravity();
    });
    connect(m_begin, &QPushButton::clicked, this, [this] { emit begun(withDetails(plan())); });
    proposeLoads();
}

void CalibrateSetup::build()
{
    m_channel->addItem(tr("Force, with reference weights"), int(Way::Weights));
    m_channel->addItem(tr("Force, with a load cell"), int(Way::LoadCell));
    m_channel->addItem(tr("Position, with gauge blocks"), int(Way::GaugeBlocks));
    m_channel->addItem(tr("Force, with masses in kilograms"), int(Way::Kilograms));
    m_channel->addItem(tr("Force, with masses in pounds"), int(Way::Pounds));
    m_channel->setObjectName("calibrationChannel");
    rememberChoice(m_channel); // what is typed below is of it
    m_loads->setObjectName("calibrationLoads");
    m_runs->setObjectName("calibrationRuns");
    m_runs->setRange(1, 20);
    m_runs->setValue(2);
    m_descending->setChecked(true);
    m_degree->setRange(1, highestCalibrationDegree);
    m_reference->setObjectName("calibrationReference");
    m_reference->setPlaceholderText(tr("for instance Weights M1, set 4711"));
    m_certificate->setPlaceholderText(tr("number, if it has one"));
    m_uncertainty->setObjectName("calibrationUncertainty");
    m_summary->setWordWrap(true);
    m_summary->setObjectName("calibrationSummary");
    m_begin->setObjectName("calibrationBegin");

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    const auto add = [&](int row, int column, int span, const QString& name, QWidget* field) {
        field->setAccessibleName(name);
        auto* label = makeLabel(name, "strong", this);
        label->setBuddy(field);
        label->setContentsMargins(0, row > 0 ? 6 : 0, 0, 0);
        grid->addWidget(label, 2 * row, column, 1, span);
        grid->addWidget(field, 2 * row + 1, column, 1, span);
        return label;
    };
    add(0, 0, 4, tr("Channel"), m_channel);
    m_loadsName = add(1, 0, 4, tr("Loads"), m_loads);
    add(2, 0, 1, tr("Runs"), m_runs);
    grid->addWidget(m_descending, 5, 1);
    add(2, 2, 2, tr("Degree of the curve"), m_degree);
    add(3, 0, 4, tr("Reference"), m_reference);
    add(4, 0, 2, tr("Its certificate"), m_certificate);
    add(4, 2, 2, tr("Its standard uncertainty"), m_uncertainty);
    m_descending->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed); // never less than its word
    for (const int column : {0, 1, 2, 3})
        grid->setColumnStretch(column, 1);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 12);
    column->addLayout(grid);
    column->addStretch(1);
    column->addWidget(m_summary);
    auto* details = makeButton(tr("For the certificate…"), {}, "", this);
    details->setObjectName("calibrationDetails");
    connect(details, &QPushButton::clicked, this, &CalibrateSetup::askForDetails);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(details);
    row->addStretch(1);
    row->addWidget(m_begin);
    column->addLayout(row);
}

void CalibrateSetup::askForDetails()
{
    if (m_detailsOf != channel())
        m_details.tolerance_si.reset(); // it was one of the other channel
    m_detailsOf = channel();
    auto* dialog = new CertificateDialog(m_details, m_detailsOf, this);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        m_details = dialog->details();
        validate();
    });
    dialog->open();
}

CalibrationPlan CalibrateSetup::withDetails(CalibrationPlan plan) const
{
    plan.reference.due = m_details.referenceDue;
    plan.checkAfter = m_details.checkAfter;
    plan.conditions.loadUnit = loadUnit();
    plan.conditions.gravity = m_workbench->settings().get(setting::gravity);
    plan.conditions.ambient_C = m_details.ambient_C;
    plan.conditions.rule = m_details.rule;
    if (m_details.tolerance_si && m_detailsOf == channel())
        plan.conditions.tolerance = *m_details.tolerance_si / siPerChannel();
    return plan;
}

LoadUnit CalibrateSetup::loadUnit() const
{
    return way() == Way::Kilograms ? LoadUnit::Kilogram
           : way() == Way::Pounds  ? LoadUnit::Pound
                                   : LoadUnit::Channel;
}

CalibrateSetup::Way CalibrateSetup::way() const
{
    return Way(m_channel->currentData().toInt());
}

SensorChannel CalibrateSetup::channel() const
{
    return way() == Way::GaugeBlocks ? SensorChannel::Position : SensorChannel::Force;
}

ShownUnit CalibrateSetup::typedUnit() const
{
    if (const auto mass = massPerNewton(loadUnit(), m_workbench->settings().get(setting::gravity)))
        return *mass;
    return fieldUnit(channel() == SensorChannel::Force ? MechanicalQuantity::Force
                                                       : MechanicalQuantity::Length);
}

double CalibrateSetup::siPerChannel() const
{
    const GripperIdentity identity = m_workbench->connection().identity();
    const std::optional<double> si =
        channel() == SensorChannel::Force ? newtonsPer(identity.forceUnit) : metresPer(identity.positionUnit);
    return si.value_or(1);
}

/// In another unit the uncertainty is another number.
void CalibrateSetup::askInUnit()
{
    constexpr double usual = 0.001; // of whatever unit is typed
    if (m_askedIn == typedUnit().unit)
        return;
    m_askedIn = typedUnit().unit;
    const bool force = channel() == SensorChannel::Force;
    m_loads->setUnit(typedUnit());
    m_loads->setToolTip(tr("In %1, the least first").arg(typedUnit().unit));
    m_loadsName->setText(tr("Loads (%1)").arg(typedUnit().unit));
    m_uncertainty->setQuantity(typedUnit(), force ? uncertainties_N : uncertainties_m,
                               force ? leastUncertainty_N : leastUncertainty_m);
    m_uncertainty->setValue(usual);
}

/// The masses that were typed stay, and are other forces.
void CalibrateSetup::takeGravity()
{
    const double uncertainty = m_uncertainty->value();
    m_loads->setUnit(typedUnit());
    m_uncertainty->setQuantity(typedUnit(), uncertainties_N, leastUncertainty_N);
    m_uncertainty->setValue(uncertainty);
    validate();
}

void CalibrateSetup::proposeLoads()
{
    askInUnit();
    // 0 to 50 N or 20 mm in five or four steps, or as near to them as round numbers of another unit come.
    const bool force = channel() == SensorChannel::Force;
    const int steps = force ? 5 : 4;
    const double step = roundBelow((force ? 50 : 20e-3) * typedUnit().factor / steps);
    QStringList loads;
    for (int i = 0; i <= steps; ++i)
        loads << QLocale().toString(i * step, 'g', 4);
    m_loads->setText(loads.join(u", "_s));
    validate();
}

CalibrationPlan CalibrateSetup::plan() const
{
    CalibrationPlan plan;
    plan.channel = channel();
    plan.loads = m_loads->si().value_or(std::vector<double>());
    for (double& load : plan.loads)
        load /= siPerChannel();
    plan.runs = m_runs->value();
    plan.descending = m_descending->isChecked();
    plan.loadsAreRead = way() == Way::LoadCell;
    plan.degree = m_degree->value();
    plan.reference = {m_reference->text().trimmed(), m_certificate->text().trimmed(),
                      m_uncertainty->si() / siPerChannel(), 0};
    return plan;
}

QString CalibrateSetup::problem() const
{
    ConnectSession& connection = m_workbench->connection();
    if (connection.state() != ConnectSession::State::Connected)
        return tr("No gripper is connected. Choose one at the top.");
    if (connection.identity().serial.isEmpty())
        return tr("This gripper has no serial number to keep its calibration under.");
    if (connection.armed())
        return tr("The gripper is armed, and hands will be near: disarm it first.");
    if (!m_loads->si())
        return tr("Loads are numbers with commas between, such as 0, 10, 20.");
    if (m_reference->text().trimmed().isEmpty())
        return tr("Say what the loads are realised with: it stands on the certificate.");
    if (const std::optional<Error> error = problemOf(withDetails(plan())))
        return error->describe();
    return {};
}

void CalibrateSetup::validate()
{
    const QString wrong = problem();
    m_begin->setEnabled(wrong.isEmpty());
    m_summary->setText(wrong.isEmpty() ? tr("%1 points, about a second each. The gripper does not move.")
                                             .arg(plannedPoints(withDetails(plan())).size())
                                       : wrong);
}

} // namespace gripscope
