// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate_page.h"

#include "core/session/calibrate_session.h"
#include "ui/charts/calibration_plot.h"
#include "ui/models/calibration_list_model.h"
#include "ui/models/calibration_words.h"
#include "ui/pages/calibrate_example.h"
#include "ui/pages/calibrate_setup.h"
#include "ui/pages/calibrate_table.h"
#include "ui/pages/calibrate_taking.h"
#include "ui/reports/calibration_certificate.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QStackedWidget>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace gripscope {

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

struct CalibratePage::Private {
    explicit Private(Workbench& bench) : session(bench.connection(), bench.library()) {}

    CalibrateSession session;
    QStackedWidget* stack = nullptr;
    CalibrateSetup* setup = nullptr;
    CalibrateTaking* taking = nullptr;
    CalibrationListModel* list = nullptr;
    QTableView* table = nullptr;
    CalibrationPlot* plot = nullptr;
    QLabel *force = nullptr, *position = nullptr, *chosen = nullptr;
    QPushButton* certificate = nullptr;
    QStackedWidget* history = nullptr;
    bool active = false, stale = true;
    CalibrateSession::State shown = CalibrateSession::State::Idle;
    bool tourLoaded = false;
};

CalibratePage::CalibratePage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>(bench))
{
    d->stack = new QStackedWidget(this);
    d->stack->addWidget(makeOverview());
    d->taking = new CalibrateTaking(bench, d->session, this);
    d->stack->addWidget(d->taking);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 12);
    column->addWidget(d->stack);
    setFocusPolicy(Qt::StrongFocus);
    connect(&bench, &Workbench::ticked, this, [this] {
        if (d->session.poll())
            refresh();
        if (d->active && d->stack->currentIndex() == 1)
            d->taking->refreshReading();
    });
    connect(&bench, &Workbench::connectionChanged, this, &CalibratePage::showStatus);
    connect(d->taking, &CalibrateTaking::abandoned, this, [this] {
        d->session.abandon();
        refresh();
    });
    refresh();
}

CalibratePage::~CalibratePage() = default;

QString CalibratePage::id() const
{
    return u"calibrate"_s;
}

QString CalibratePage::title() const
{
    return tr("Calibrate");
}

QString CalibratePage::iconName() const
{
    return u"measure"_s;
}

QWidget* CalibratePage::makeOverview()
{
    auto* overview = new QWidget(this);
    QFrame* card = makeCard(overview);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    auto* status = new QGridLayout;
    status->setHorizontalSpacing(16);
    status->setVerticalSpacing(4);
    status->setColumnStretch(1, 1);
    int line = 0;
    for (const auto& [label, name] :
         {std::pair(&d->force, tr("Force")), std::pair(&d->position, tr("Position"))}) {
        *label = makeLabel({}, "second", card);
        (*label)->setWordWrap(true);
        status->addWidget(makeLabel(name, "strong", card), line, 0, Qt::AlignTop);
        status->addWidget(*label, line++, 1, Qt::AlignTop);
    }
    column->addLayout(status);
    d->force->setObjectName("forceCalibrationStatus");
    column->addWidget(makeRule(card));
    d->setup = new CalibrateSetup(workbench(), card);
    connect(d->setup, &CalibrateSetup::begun, this, [this](const CalibrationPlan& plan) {
        if (const Expected<void> begun = d->session.start(plan); !begun)
            workbench().report(begun.error().describe());
        refresh();
    });
    column->addWidget(d->setup, 1);
    auto* row = new QHBoxLayout(overview);
    setSpacing(row, 0, 16);
    card->setFixedWidth(432);
    row->addWidget(card);
    row->addWidget(makeHistory(), 1);
    return overview;
}

QWidget* CalibratePage::makeHistory()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    column->addWidget(makeLabel(tr("Calibrations"), "heading", card));
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
    d->chosen = makeLabel({}, "caption", shown);
    d->chosen->setWordWrap(true);
    d->certificate = makeButton(tr("Certificate…"), u"document-save"_s, "", shown);
    d->certificate->setObjectName("certificateButton");
    inside->addWidget(d->table, 1);
    inside->addWidget(d->plot, 1);
    inside->addWidget(d->chosen);
    inside->addWidget(d->certificate, 0, Qt::AlignRight);
    d->history->addWidget(empty);
    d->history->addWidget(shown);
    column->addWidget(d->history, 1);
    connect(d->table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& index) {
                const CalibrationRow* row = index.isValid() ? &d->list->row(index.row()) : nullptr;
                d->certificate->setEnabled(row != nullptr);
                d->plot->clear();
                d->chosen->clear();
                if (row == nullptr || !row->evaluation)
                    return;
                d->plot->setCalibration(row->record, *row->evaluation);
                d->chosen->setText(CalibrationWords::curve(*row->evaluation));
            });
    connect(d->certificate, &QPushButton::clicked, this, &CalibratePage::saveCertificate);
    return card;
}

const CalibrationRecord* CalibratePage::selected() const
{
    const QModelIndex index = d->table->currentIndex();
    return index.isValid() ? &d->list->row(index.row()).record : nullptr;
}

void CalibratePage::saveCertificate()
{
    const CalibrationRecord* record = selected();
    if (record == nullptr)
        return;
    const QString proposal = u"calibration-%1-%2-%3.pdf"_s.arg(
        record->gripperSerial, toString(record->channel), record->takenUtc.date().toString(Qt::ISODate));
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save the certificate"), proposal, tr("PDF (*.pdf)"));
    if (file.isEmpty())
        return;
    workbench().compute<Expected<void>>(
        this,
        [record = *record, picture = residualPicture(*record), file] {
            return writeCertificate(record, picture, file);
        },
        [this](const Expected<void>& done) {
            if (!done)
                workbench().report(done.error().describe());
        });
}

void CalibratePage::setActive(bool active)
{
    d->active = active;
    if (!active)
        return;
    if (d->stale)
        reload();
    setFocus();
}

void CalibratePage::reload()
{
    d->stale = false;
    workbench().ask<std::vector<CalibrationRow>>(this, readRows,
                                                 [this](Expected<std::vector<CalibrationRow>> rows) {
                                                     if (!rows)
                                                         return workbench().report(rows.error().describe());
                                                     const bool any = !rows->empty();
                                                     d->list->setRows(std::move(*rows));
                                                     d->history->setCurrentIndex(any ? 1 : 0);
                                                     if (any)
                                                         d->table->selectRow(0);
                                                     d->tourLoaded = any;
                                                 });
}

void CalibratePage::showStatus()
{
    const CalibrationsInForce& known = workbench().connection().calibration().inForce();
    const QDate today = QDate::currentDate();
    d->force->setText(CalibrationWords::status(known.force, today));
    d->position->setText(CalibrationWords::status(known.position, today));
    const QString& unusable = workbench().connection().calibration().unusable();
    if (!unusable.isEmpty())
        d->force->setText(unusable);
}

void CalibratePage::refresh()
{
    using State = CalibrateSession::State;
    const State state = d->session.state();
    if (state == State::Stored && d->shown != state) {
        d->session.abandon();
        reload();
        workbench().tellCalibrationChanged();
    }
    d->shown = d->session.state();
    const bool under = d->shown != State::Idle && d->shown != State::Stored;
    d->stack->setCurrentIndex(under ? 1 : 0);
    showStatus();
    if (under)
        d->taking->refresh();
}

void CalibratePage::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && d->stack->currentIndex() == 1)
        d->taking->takeOrAccept();
    else
        Page::keyPressEvent(event);
}

void CalibratePage::prepareTour()
{
    workbench().ask<void>(
        this, [](Library& library) { return library.addCalibration(exampleCalibration()); },
        [this](const Expected<void>& done) {
            if (!done)
                workbench().report(done.error().describe());
            reload();
            workbench().connectTo(u"virtual:"_s);
        });
}

bool CalibratePage::tourReady() const
{
    return d->tourLoaded && workbench().connection().calibration().inForce().force;
}

} // namespace gripscope
