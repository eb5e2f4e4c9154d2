// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/calibrate_session.h"
#include "ui/charts/calibration_plot.h"
#include "ui/context/workbench.h"
#include "ui/format/calibration_words.h"
#include "ui/format/date_text.h"
#include "ui/format/study_due_words.h"
#include "ui/models/calibration_models.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/pages/calibrate/calibrate_taking.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/reports/reports.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"
#include "ui/windows/file_dialog.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QStackedWidget>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace gripscope {

QTableView* makeCalibrationTable(QAbstractItemModel& model, QWidget* parent)
{
    auto* table = new QTableView(parent);
    table->setModel(&model);
    setUpRowList(table, 32);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

namespace {

constexpr int mostShown = 500;

/// The list with its evaluations, made where the library is read.
Expected<std::vector<CalibrationRow>> readRows(Library& library)
{
    return library.calibrations({}, mostShown).map([](const std::vector<CalibrationRecord>& records) {
        std::vector<CalibrationRow> rows;
        rows.reserve(records.size());
        for (const CalibrationRecord& record : records) {
            const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(record);
            rows.push_back({record, evaluation ? std::optional(*evaluation) : std::nullopt});
        }
        return rows;
    });
}

} // namespace

struct CalibrateSensors::Private {
    explicit Private(Workbench& workbench)
        : bench(workbench), session(workbench.connection(), workbench.library())
    {
    }

    Workbench& bench;
    CalibrateSession session;
    QStackedWidget* stack = nullptr;
    CalibrateSetup* setup = nullptr;
    CalibrateTaking* taking = nullptr;
    CalibrationListModel* list = nullptr;
    QTableView* table = nullptr;
    CalibrationPlot* plot = nullptr;
    QLabel *force = nullptr, *position = nullptr, *studies = nullptr, *chosen = nullptr;
    std::vector<StudyRecord> studied; ///< as the library had them when it was last asked
    QPushButton* certificate = nullptr;
    QStackedWidget* history = nullptr;
    bool active = false, stale = true;
    CalibrateSession::State shown = CalibrateSession::State::Idle;
};

CalibrateSensors::CalibrateSensors(Workbench& workbench, QWidget* parent)
    : QWidget(parent), d(std::make_unique<Private>(workbench))
{
    d->stack = new QStackedWidget(this);
    d->stack->addWidget(makeOverview());
    d->taking = new CalibrateTaking(workbench, d->session, this);
    d->stack->addWidget(d->taking);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 0);
    column->addWidget(d->stack);
    connect(&workbench, &Workbench::ticked, this, [this] {
        if (d->session.poll())
            refresh();
        if (d->active && d->stack->currentIndex() == 1)
            d->taking->refreshReading();
    });
    connect(&workbench, &Workbench::connectionChanged, this, &CalibrateSensors::showStatus);
    connect(d->taking, &CalibrateTaking::abandoned, this, [this] {
        d->session.abandon();
        refresh();
    });
    refresh();
}

CalibrateSensors::~CalibrateSensors() = default;

QWidget* CalibrateSensors::makeOverview()
{
    auto* overview = new QWidget(this);
    QFrame* card = makeCard(overview);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    d->setup = new CalibrateSetup(d->bench, card);
    connect(d->setup, &CalibrateSetup::begun, this, [this](const CalibrationPlan& plan) {
        if (const Expected<void> begun = d->session.start(plan); !begun)
            d->bench.messages().report(begun.error().describe());
        refresh();
    });
    column->addWidget(d->setup, 1);
    auto* row = new QHBoxLayout(overview);
    setSpacing(row, 0, 16);
    card->setFixedWidth(400);
    row->addWidget(card);
    row->addWidget(makeHistory(), 1);
    return overview;
}

QLayout* CalibrateSensors::makeStatus(QWidget* card)
{
    auto* status = new QGridLayout;
    status->setHorizontalSpacing(16);
    status->setVerticalSpacing(4);
    status->setColumnStretch(1, 1);
    int line = 0;
    for (const auto& [label, name] :
         {std::pair(&d->force, tr("Force")), std::pair(&d->position, tr("Position")),
          std::pair(&d->studies, tr("Studies"))}) {
        *label = makeLabel({}, "second", card);
        (*label)->setWordWrap(true);
        status->addWidget(makeLabel(name, "strong", card), line, 0, Qt::AlignTop);
        status->addWidget(*label, line++, 1, Qt::AlignTop);
    }
    d->force->setObjectName("forceCalibrationStatus");
    d->studies->setObjectName("studiesStatus");
    return status;
}

QWidget* CalibrateSensors::makeHistory()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    column->addLayout(makeStatus(card));
    column->addWidget(makeRule(card));
    d->history = new QStackedWidget(card);
    d->history->setStyleSheet(u"QStackedWidget, QWidget#storedCalibrations { background: transparent; }"_s);
    auto* empty =
        makeLabel(tr("None yet. Choose a channel and its loads on the left, put on one after the other, "
                     "and look at what is left beside the curve before you accept it."),
                  "second", card);
    empty->setWordWrap(true);
    empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* shown = new QWidget(card);
    shown->setObjectName("storedCalibrations");
    auto* inside = new QVBoxLayout(shown);
    setSpacing(inside, 0, 8);
    d->list = new CalibrationListModel(this);
    d->table = makeCalibrationTable(*d->list, shown);
    d->table->setObjectName("calibrationList");
    d->table->setAccessibleName(tr("Calibrations"));
    d->plot = new CalibrationPlot(shown);
    (new FitExporter(d->bench, this))->addFigure(d->plot); // its context menu
    d->chosen = makeLabel({}, "caption", shown);
    d->chosen->setWordWrap(true);
    d->certificate = makeButton(tr("Certificate…"), u"document-save"_s, "", shown);
    d->certificate->setObjectName("certificateButton");
    inside->addWidget(d->table, 2);
    inside->addWidget(d->plot, 3);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(d->chosen, 1);
    row->addWidget(d->certificate);
    inside->addLayout(row);
    d->history->addWidget(empty);
    d->history->addWidget(shown);
    column->addWidget(d->history, 1);
    connect(d->table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &CalibrateSensors::showSelected);
    connect(d->certificate, &QPushButton::clicked, this, &CalibrateSensors::saveCertificate);
    return card;
}

void CalibrateSensors::showSelected()
{
    const QModelIndex index = d->table->currentIndex();
    const CalibrationRow* row = index.isValid() ? &d->list->row(index.row()) : nullptr;
    d->certificate->setEnabled(row != nullptr);
    d->plot->clear();
    d->chosen->clear();
    if (row == nullptr || !row->evaluation)
        return;
    d->plot->setCalibration(row->record, *row->evaluation);
    d->chosen->setText(tr("Gripper %1, by %2").arg(row->record.gripperSerial, row->record.operatorName) +
                       u'\n' + CalibrationWords::curve(*row->evaluation, row->record.unit));
}

void CalibrateSensors::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    // What stands below the plot, too, gives way first.
    constexpr int roomForAll = 1100;
    for (const auto column : {CalibrationListModel::Column::Gripper, CalibrationListModel::Column::By})
        d->table->setColumnHidden(int(column), width() < roomForAll);
}

const CalibrationRecord* CalibrateSensors::selected() const
{
    const QModelIndex index = d->table->currentIndex();
    return index.isValid() ? &d->list->row(index.row()).record : nullptr;
}

void CalibrateSensors::saveCertificate()
{
    const CalibrationRecord* record = selected();
    if (record == nullptr)
        return;
    const QString proposal = u"calibration-%1-%2-%3.pdf"_s.arg(
        record->gripperSerial, toString(record->channel), dateText(record->takenUtc));
    auto* dialog = new FileDialog(this, tr("Save the certificate"), QString(), tr("PDF (*.pdf)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"pdf"_s);
    dialog->selectFile(proposal);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, record = *record](const QString& file) { writeCertificateTo(file, record); });
    dialog->open();
}

void CalibrateSensors::writeCertificateTo(const QString& file, const CalibrationRecord& record)
{
    const auto write = [this, record, file] {
        d->bench.background().compute<Expected<void>>(
            this,
            [record, picture = residualPicture(record), letterhead = letterheadSource(d->bench.settings()),
             file] { return writeCertificate(record, picture, letterhead, file); },
            [this, file](const Expected<void>& done) {
                if (done)
                    d->bench.messages().tell(tr("Certificate written to %1").arg(file));
                else
                    d->bench.messages().report(done.error().describe());
            });
    };
    // First into the audit trail, as every export: no certificate goes out that is not in it.
    d->bench.background().ask<void>(
        this, [file](Library& library) { return library.tellExport(file, u"certificate"_s, 1); },
        [this, write](const Expected<void>& entered) {
            if (entered)
                write();
            else
                d->bench.messages().report(entered.error().describe());
        });
}

void CalibrateSensors::setActive(bool active)
{
    d->active = active;
    if (active && d->stale)
        reload();
}

bool CalibrateSensors::underWay() const
{
    return d->stack->currentIndex() == 1;
}

bool CalibrateSensors::loaded() const
{
    return d->list->rowCount() > 0;
}

void CalibrateSensors::reload()
{
    d->stale = false;
    d->bench.background().ask<std::vector<CalibrationRow>>(
        this, readRows, [this](Expected<std::vector<CalibrationRow>> rows) {
            if (!rows)
                return d->bench.messages().report(rows.error().describe());
            d->list->setRows(std::move(*rows));
            fitHeightToRows(d->table, mostRowsBesidePlot);
            d->history->setCurrentIndex(loaded() ? 1 : 0);
            if (loaded())
                d->table->selectRow(0);
        });
    using Studies = std::vector<StudyRecord>;
    d->bench.background().ask<Studies>(
        this, [](Library& library) { return library.studies(mostShown); },
        [this](Expected<Studies> studies) {
            d->studied = std::move(studies).value_or(Studies());
            showStatus();
        });
}

void CalibrateSensors::showStatus()
{
    const ChannelCalibration& known = d->bench.connection().calibration();
    const QDate today = QDate::currentDate();
    d->force->setText(CalibrationWords::status(known.record(SensorChannel::Force), today));
    d->position->setText(CalibrationWords::status(known.record(SensorChannel::Position), today));
    if (!known.unusable().isEmpty())
        d->force->setText(known.unusable());
    const ConnectSession& connection = d->bench.connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    d->studies->setText(StudyDueWords::lines(
        studyStandings(d->studied, connected ? connection.identity().serial : QString()), today));
}

void CalibrateSensors::refresh()
{
    using State = CalibrateSession::State;
    const State state = d->session.state();
    if (state == State::Stored && d->shown != state) {
        d->session.abandon();
        reload();
        d->bench.tellCalibrationChanged();
    }
    d->shown = d->session.state();
    const bool under = d->shown != State::Idle && d->shown != State::Stored;
    if (under != (d->stack->currentIndex() == 1))
        emit takingChanged(under);
    d->stack->setCurrentIndex(under ? 1 : 0);
    showStatus();
    if (under)
        d->taking->refresh();
}

void CalibrateSensors::act()
{
    if (d->stack->currentIndex() == 1)
        d->taking->takeOrAccept();
}

void CalibrateSensors::undo()
{
    if (d->stack->currentIndex() == 1)
        d->taking->undo();
}

} // namespace gripscope
