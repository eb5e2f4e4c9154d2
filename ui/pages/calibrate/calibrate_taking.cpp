// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate/calibrate_taking.h"

#include "ui/charts/calibration_plot.h"
#include "ui/context/workbench.h"
#include "ui/format/calibration_words.h"
#include "ui/format/channel_scale.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/models/calibration_models.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QProgressBar>
#include <QScrollArea>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr int usualMonths = 12;
} // namespace

CalibrateTaking::CalibrateTaking(Workbench& workbench, CalibrateSession& session, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_session(&session)
{
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(makePlots(), 1);
    row->addWidget(makeSide());
}

CalibrateTaking::~CalibrateTaking() = default;

QWidget* CalibrateTaking::makePlots()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 8, 8);
    m_plot = new CalibrationPlot(card);
    (new FitExporter(*m_workbench, this))->addFigure(m_plot); // its context menu
    m_model = new CalibrationPointsModel(this);
    m_table = makeCalibrationTable(*m_model, card);
    m_table->setObjectName("calibrationPoints");
    m_table->verticalHeader()->setMinimumSectionSize(32);
    letRowsWrap(m_table); // remarks are sentences
    column->addWidget(m_plot, 2);
    column->addWidget(m_table, 3);
    return card;
}

QWidget* CalibrateTaking::makeSide()
{
    QFrame* card = makeCard(this);
    card->setFixedWidth(320);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    m_title = makeLabel({}, "heading", card);
    m_title->setWordWrap(true);
    m_stack = new QStackedWidget(card);
    m_stack->addWidget(makeNext());
    m_stack->addWidget(makeDecision());
    m_words = makeLabel({}, "error", card);
    m_words->setObjectName("calibrationWords");
    m_words->setWordWrap(true);
    m_undo = makeButton(tr("Undo the last (Backspace)"), u"edit-undo"_s, "", card);
    m_undo->setObjectName("calibrationUndo");
    m_abandon = makeButton(tr("Leave it"), u"dialog-cancel"_s, "quiet", card);
    m_abandon->setObjectName("calibrationAbandon");
    column->addWidget(m_title);
    column->addWidget(m_stack, 1);
    column->addWidget(m_words);
    column->addWidget(m_undo);
    column->addWidget(m_abandon);
    connect(m_undo, &QPushButton::clicked, this, &CalibrateTaking::undo);
    connect(m_abandon, &QPushButton::clicked, this, [this] {
        m_proposed = 0; // the next calibration has other loads
        emit abandoned();
    });
    return card;
}

QWidget* CalibrateTaking::makeNext()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    setSpacing(column, 0, 8);
    m_step = makeLabel({}, "second", box);
    m_load = makeLabel({}, "big-number", box);
    m_load->setObjectName("calibrationLoad");
    m_way = makeLabel({}, "second", box);
    m_way->setWordWrap(true);
    m_shownBox = new QWidget(box);
    m_onIt = new QDoubleSpinBox(m_shownBox);
    m_onIt->setObjectName("calibrationShown");
    m_onIt->setAccessibleName(tr("The load cell shows"));
    m_onIt->setDecimals(4);
    auto* shownRow = new QHBoxLayout(m_shownBox);
    setSpacing(shownRow, 0, 8);
    shownRow->addWidget(makeLabel(tr("The load cell shows"), "strong", m_shownBox));
    shownRow->addWidget(m_onIt, 1);
    m_reading = makeLabel({}, "number", box);
    m_steady = makeLabel({}, "second", box);
    m_steady->setObjectName("calibrationSteady");
    m_progress = new QProgressBar(box);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Reading the channel"));
    m_take = makeButton(tr("Take it (Space)"), u"dialog-ok-apply"_s, "primary", box);
    m_take->setObjectName("calibrationTake");
    column->addWidget(m_step);
    column->addWidget(m_load);
    column->addWidget(m_way);
    column->addWidget(m_shownBox);
    column->addStretch(1);
    column->addWidget(makeLabel(tr("The channel says"), "caption", box));
    column->addWidget(m_reading);
    column->addWidget(m_steady);
    column->addStretch(1);
    column->addWidget(m_progress);
    column->addWidget(m_take);
    connect(m_take, &QPushButton::clicked, this, &CalibrateTaking::take);
    return box;
}

QWidget* CalibrateTaking::makeDecision()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    setSpacing(column, 0, 8);
    auto* found = new QWidget;
    auto* results = new QVBoxLayout(found);
    setSpacing(results, 0, 8);
    m_figures = makeFactGrid();
    m_doubt = makeLabel({}, "error", box);
    m_doubt->setWordWrap(true);
    results->addLayout(m_figures);
    results->addWidget(m_doubt);
    results->addStretch(1);
    m_degree = new QSpinBox(box);
    m_degree->setRange(1, highestCalibrationDegree);
    m_due = new QDateEdit(box);
    m_due->setCalendarPopup(true);
    m_due->setDisplayFormat(dateFormat.toString());
    m_due->setMinimumDate(QDate::currentDate());
    m_due->setDate(QDate::currentDate().addMonths(usualMonths));
    m_note = new QLineEdit(box);
    m_note->setMaxLength(200);
    m_note->setPlaceholderText(tr("Note"));
    m_note->setAccessibleName(tr("Note"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(8);
    const std::pair<QString, QWidget*> fields[] = {{tr("Degree of the curve"), m_degree},
                                                   {tr("Holds until"), m_due}};
    int line = 0;
    for (const auto& [name, field] : fields) {
        field->setAccessibleName(name);
        auto* label = makeLabel(name, "strong", box);
        label->setBuddy(field);
        grid->addWidget(label, line, 0);
        grid->addWidget(field, line++, 1);
    }
    m_accept = makeButton(tr("Accept"), u"dialog-ok-apply"_s, "primary", box);
    m_accept->setObjectName("calibrationAccept");
    column->addWidget(makeScroll(found, box), 1);
    column->addLayout(grid);
    column->addWidget(m_note);
    column->addWidget(m_accept);
    connect(m_degree, &QSpinBox::valueChanged, this, [this](int degree) {
        m_session->setDegree(degree);
        refresh();
    });
    connect(m_accept, &QPushButton::clicked, this, &CalibrateTaking::accept);
    return box;
}

QString CalibrateTaking::shown(double value, int digits) const
{
    return formatNumber(value, {}, m_session->calibration().unit, digits).valueWithUnit();
}

void CalibrateTaking::take()
{
    const std::optional<double> load =
        m_session->plan().loadsAreRead ? std::optional(m_onIt->value() / m_perChannel) : std::nullopt;
    if (m_session->state() == CalibrateSession::State::Reading)
        m_session->stopReading();
    else if (const Expected<void> begun = m_session->take(load); !begun)
        m_workbench->messages().report(begun.error().describe());
    refresh();
}

void CalibrateTaking::undo()
{
    m_session->undo();
    m_proposed = 0;
    refresh();
}

void CalibrateTaking::accept()
{
    const auto acceptBecause = [this](const QString& note) {
        authorize(*m_workbench, this, Permission::AcceptCalibrations, [this, note] {
            m_session->setOperator(m_workbench->operatorName());
            if (const Expected<void> begun = m_session->accept(m_due->date(), note); !begun)
                m_workbench->messages().report(begun.error().describe());
            refresh();
        });
    };
    if (const QString note = m_note->text().trimmed(); !note.isEmpty())
        acceptBecause(note);
    else
        askWhy(this, tr("Accept the calibration"), acceptBecause);
}

void CalibrateTaking::takeOrAccept()
{
    if (m_session->next())
        take();
    else if (m_accept->isEnabled())
        m_accept->setFocus();
}

void CalibrateTaking::refresh()
{
    const SensorCalibration calibration = m_session->calibration();
    m_title->setText(
        tr("%1 of %2").arg(CalibrationWords::channel(calibration.channel), calibration.gripperName));
    const bool waiting = m_session->state() == CalibrateSession::State::Waiting;
    m_undo->setEnabled(waiting && !m_session->points().empty());
    m_abandon->setEnabled(m_session->state() != CalibrateSession::State::Storing);
    m_words->setText(m_session->error()             ? m_session->error()->describe()
                     : !m_session->points().empty() ? m_session->points().back().doubt
                                                    : QString());
    m_words->setVisible(!m_words->text().isEmpty());
    m_stack->setCurrentIndex(m_session->next() ? 0 : 1);
    showPoints();
    showNext();
    showFigures();
}

void CalibrateTaking::showPoints()
{
    const SensorCalibration calibration = m_session->calibration();
    const auto& evaluation = m_session->evaluation();
    const bool known = evaluation && *evaluation;
    std::vector<double> residuals = known ? (*evaluation)->residuals : std::vector<double>();
    for (const CalibrationPoint& point : calibration.checkPoints) // which come last
        if (known)
            residuals.push_back(point.reading - (*evaluation)->curve.readingAt(point.load));
    m_model->setPoints(calibration.unit, m_session->planned(), m_session->points(), std::move(residuals),
                       known ? (*evaluation)->expandedUncertainty : 0);
    if (known)
        m_plot->setCalibration(calibration, **evaluation);
    else
        m_plot->clear();
    m_table->scrollTo(m_model->index(std::min(int(m_session->points().size()), m_model->rowCount() - 1), 0));
}

void CalibrateTaking::showNext()
{
    const std::optional<PlannedPoint> next = m_session->next();
    const bool reading = m_session->state() == CalibrateSession::State::Reading;
    m_progress->setValue(int(100 * m_session->readingProgress()));
    m_take->setText(reading ? tr("Cancel") : tr("Take it (Space)"));
    if (!next)
        return;
    const QString step = next->check ? tr("Check afterwards: point %1 of %2") : tr("Point %1 of %2");
    m_step->setText(step.arg(m_session->points().size() + 1).arg(m_session->planned().size()));
    showLoad(*next);
    m_way->setText(instruction(*next, m_session->plan()));
}

void CalibrateTaking::showLoad(const PlannedPoint& next)
{
    const CalibrationPlan& plan = m_session->plan();
    const QString unit = m_session->calibration().unit;
    const auto mass = massPerLoad(plan.conditions.loadUnit, plan.conditions.gravity, unit);
    const ChannelScale scale =
        mass ? ChannelScale{mass->unit, mass->factor} : channelScale(unit, plan.loads.back());
    m_perChannel = scale.factor;
    m_load->setText(QLocale().toString(scale.factor * next.load, 'g', 6) + QChar(QChar::Nbsp) + scale.unit);
    m_shownBox->setVisible(plan.loadsAreRead);
    if (!plan.loadsAreRead || m_proposed == m_session->points().size() + 1)
        return;
    m_proposed = m_session->points().size() + 1;
    constexpr double farthest = 10; ///< times the largest load: what a slip of the finger types
    m_onIt->setRange(-farthest * scale.factor * plan.loads.back(),
                     farthest * scale.factor * plan.loads.back());
    m_onIt->setSuffix(QChar(QChar::Nbsp) + scale.unit);
    m_onIt->setValue(scale.factor * next.load);
}

QString CalibrateTaking::instruction(const PlannedPoint& next, const CalibrationPlan& plan)
{
    if (plan.channel == SensorChannel::Position)
        return next.ascending ? tr("Coming from less: set the fingers on this block, and let them rest.")
                              : tr("Coming from more: set the fingers on this block, and let them rest.");
    if (next.load == 0)
        return tr("Take everything off, and let it rest.");
    if (plan.loadsAreRead)
        return next.ascending
                   ? tr("Press up to about this, not beyond, hold it, and type what the cell shows.")
                   : tr("Give way down to about this, hold it, and type what the cell shows.");
    return next.ascending ? tr("Add weights up to this, never beyond, and let them rest.")
                          : tr("Take weights off down to this, never below, and let them rest.");
}

void CalibrateTaking::showFigures()
{
    const auto& evaluation = m_session->evaluation();
    {
        const QSignalBlocker quiet(m_degree);
        m_degree->setValue(m_session->plan().degree);
    }
    const bool waiting = m_session->state() == CalibrateSession::State::Waiting;
    m_accept->setEnabled(waiting && evaluation && *evaluation);
    if (m_session->next() || !evaluation)
        return;
    fillFacts(m_figures, *evaluation
                             ? CalibrationWords::figures(m_session->calibration(), **evaluation)
                             : std::vector<Fact>{{tr("No curve"), evaluation->error().describe(), false}});
    m_doubt->setText(*evaluation ? CalibrationWords::doubt(**evaluation) : QString());
    m_doubt->setVisible(!m_doubt->text().isEmpty());
}

std::vector<double> CalibrateTaking::recentValues() const
{
    constexpr double watched_s = 1;
    constexpr int columns = 40;
    const bool force = m_session->plan().channel == SensorChannel::Force;
    const LiveHistory& history = m_workbench->live().history();
    const auto stretches =
        history.columns(force ? LiveHistory::Channel::Force : LiveHistory::Channel::Position,
                        history.newestTime_s(), watched_s, columns);
    std::vector<double> values;
    if (!stretches.empty()) // what came before a gap tells nothing of now
        for (const auto& point : stretches.back())
            values.push_back(point.y);
    return values;
}

void CalibrateTaking::refreshReading()
{
    const std::vector<double> values = recentValues();
    SteadyOptions options;
    options.driftAllowed = m_session->driftAllowed();
    const SteadyReading second = steadyReading(values, options);
    constexpr std::size_t newest = 16;
    const std::size_t count = std::min(newest, values.size());
    const double now =
        std::accumulate(values.end() - std::ptrdiff_t(count), values.end(), 0.0) / double(count);
    const ConnectSession& connection = m_workbench->connection();
    m_reading->setText(count > 0 ? shown(connection.uncorrected(m_session->plan().channel, now), 4) : u"–"_s);
    m_steady->setText(second.status == SteadyStatus::Steady   ? tr("● rests: it can be taken")
                      : second.status == SteadyStatus::Moving ? tr("◌ still moves: wait")
                                                              : tr("◌ not enough samples yet"));
    m_progress->setValue(int(100 * m_session->readingProgress()));
}

} // namespace gripscope
