// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/measuring_sessions.h"
#include "ui/charts/calibration_plot.h"
#include "ui/context/workbench.h"
#include "ui/format/reference_words.h"
#include "ui/models/calibration_models.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/pages/shared/guided_squeezes.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QGridLayout>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr int mostChecksShown = 500;

/// What a new reference object is proposed with.
ReferenceObject proposal(const QString& serial)
{
    ReferenceObject reference;
    reference.gripperSerial = serial;
    return reference;
}

} // namespace

struct CalibrateCheck::Private {
    explicit Private(Workbench& workbench)
        : bench(workbench), session(workbench.connection(), workbench.library())
    {
    }

    Workbench& bench;
    ReferenceCheckSession session;
    GuidedSqueezes* guide = nullptr;
    ReferenceCheckModel* model = nullptr;
    CheckTrendPlot* plot = nullptr;
    QTableView* table = nullptr;
    QStackedWidget* history = nullptr;
    QGridLayout* reference = nullptr;
    QLabel* standing = nullptr;
    QPushButton* edit = nullptr;
    std::vector<Fact> shownFacts;
    bool active = false, known = false;
    QString loadedFor; ///< serial number of the gripper whose checks are shown
    [[nodiscard]] const std::optional<ReferenceStanding>& inUse() const
    {
        return bench.connection().calibration().reference();
    }
};

CalibrateCheck::CalibrateCheck(Workbench& workbench, QWidget* parent)
    : QWidget(parent), d(std::make_unique<Private>(workbench))
{
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(makeCheck());
    row->addWidget(makeHistory(), 1);
    connect(&workbench, &Workbench::connectionChanged, this, [this] {
        showStanding();
        if (d->active && d->loadedFor != serial())
            reload();
    });
    connect(d->guide, &GuidedSqueezes::changed, this, [this] {
        showStanding();
        if (d->session.state() != SeriesSession::State::Stored || d->known)
            return;
        d->known = true;
        d->bench.tellCalibrationChanged();
        reload();
    });
    showStanding();
}

CalibrateCheck::~CalibrateCheck() = default;

QWidget* CalibrateCheck::makeCheck()
{
    QFrame* card = makeCard(this);
    card->setFixedWidth(400);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    auto* head = new QHBoxLayout;
    head->addWidget(makeLabel(tr("Check on a reference spring"), "heading", card), 1);
    column->addLayout(head);
    d->standing = makeLabel({}, "", card);
    d->standing->setObjectName("checkStanding");
    d->standing->setWordWrap(true);
    column->addWidget(d->standing);
    d->reference = makeFactGrid();
    column->addLayout(d->reference);
    d->edit = makeButton({}, {}, "", card);
    d->edit->setObjectName("referenceEdit");
    connect(d->edit, &QPushButton::clicked, this, &CalibrateCheck::editReference);
    column->addWidget(makeRule(card));

    GuidedSqueezes::Script script;
    script.name = u"check"_s;
    script.begin = [] { return tr("Check now (Space)"); };
    script.again = [] { return tr("Check again (Space)"); };
    script.obstacle = [this] {
        return d->inUse()
                   ? QString()
                   : tr("State first what the gripper is to be checked on: a spring whose stiffness is "
                        "known better than you need it.");
    };
    script.start = [this] {
        d->known = false;
        return d->session.start();
    };
    script.found = [] { return QString(); };
    script.outcome = [this] {
        return d->session.check() ? ReferenceWords::outcome(*d->session.check()) : QString();
    };
    d->guide = new GuidedSqueezes(d->bench, d->session, std::move(script), card);
    d->guide->addButton(d->edit);
    column->addWidget(d->guide, 1);
    return card;
}

QWidget* CalibrateCheck::makeHistory()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    column->addWidget(makeLabel(tr("Checks"), "heading", card));
    d->history = new QStackedWidget(card);
    d->history->setStyleSheet(u"QStackedWidget, QWidget#storedChecks { background: transparent; }"_s);
    auto* empty =
        makeLabel(tr("None yet. Grip the spring, arm, and check: the errors found are kept here, so "
                     "that a drift shows before it matters."),
                  "second", card);
    empty->setWordWrap(true);
    empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* shown = new QWidget(card);
    shown->setObjectName("storedChecks");
    auto* inside = new QVBoxLayout(shown);
    setSpacing(inside, 0, 8);
    d->plot = new CheckTrendPlot(shown);
    (new FitExporter(d->bench, this))->addFigure(d->plot); // its context menu
    d->model = new ReferenceCheckModel(this);
    d->table = makeCalibrationTable(*d->model, shown);
    d->table->setObjectName("checkList");
    d->table->setAccessibleName(tr("Checks"));
    inside->addWidget(d->plot, 3);
    inside->addWidget(d->table, 2);
    d->history->addWidget(empty);
    d->history->addWidget(shown);
    column->addWidget(d->history, 1);
    return card;
}

QString CalibrateCheck::serial() const
{
    const ConnectSession& connection = d->bench.connection();
    return connection.state() == ConnectSession::State::Connected ? connection.identity().serial : QString();
}

void CalibrateCheck::setActive(bool active)
{
    d->active = active;
    if (active && d->loadedFor != serial())
        reload();
    if (active)
        showStanding(); // it may have become due meanwhile
}

void CalibrateCheck::act()
{
    if (d->guide->button()->isEnabled())
        d->guide->act();
}

bool CalibrateCheck::underWay() const
{
    return d->session.busy();
}

void CalibrateCheck::leave()
{
    d->guide->leave();
}

bool CalibrateCheck::loaded() const
{
    return !d->model->checks().empty();
}

void CalibrateCheck::reload()
{
    d->loadedFor = serial();
    if (d->loadedFor.isEmpty())
        return showChecks({});
    using Checks = std::vector<ReferenceCheckRecord>;
    d->bench.background().ask<Checks>(
        this,
        [serial = d->loadedFor](Library& library) {
            return library.referenceChecks(serial, mostChecksShown);
        },
        [this, serial = d->loadedFor](Expected<Checks> checks) {
            if (!checks)
                return d->bench.messages().report(checks.error().describe());
            if (serial == d->loadedFor)
                showChecks(std::move(*checks));
        });
}

void CalibrateCheck::showChecks(std::vector<ReferenceCheckRecord> checks)
{
    d->plot->setChecks(checks, QDateTime::currentDateTimeUtc());
    d->model->setChecks(std::move(checks));
    fitHeightToRows(d->table, mostRowsBesidePlot);
    using Column = ReferenceCheckModel::Column;
    for (const Column column : {Column::Mass, Column::Damping, Column::Stiffness})
        d->table->setColumnHidden(int(column), !d->model->says(column));
    d->history->setCurrentIndex(loaded() ? 1 : 0);
}

void CalibrateCheck::showStanding()
{
    const std::optional<ReferenceStanding>& standing = d->inUse();
    const QDateTime now = QDateTime::currentDateTimeUtc();
    const CheckStatus status = checkStatus(standing, now);
    d->standing->setText(ReferenceWords::status(standing, now));
    setRole(d->standing, status == CheckStatus::Due || status == CheckStatus::Failed ? "error" : "second");
    const std::vector<Fact> facts =
        standing ? ReferenceWords::reference(standing->reference) : std::vector<Fact>();
    fillFacts(d->reference, facts);
    d->edit->setText(standing ? tr("Change it…") : tr("State the spring…"));
    setRole(d->edit, standing ? "" : "primary"); // the first step
    d->edit->setEnabled(!serial().isEmpty() && !d->session.busy());
    d->guide->refresh();
}

void CalibrateCheck::editReference()
{
    const auto& standing = d->inUse();
    ReferenceObject known = proposal(serial());
    if (standing)
        known = standing->reference;
    auto* dialog = new ReferenceDialog(known, this);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { keepReference(dialog->reference()); });
    dialog->open();
}

void CalibrateCheck::keepReference(const ReferenceObject& reference)
{
    ReferenceObject stated = reference;
    stated.operatorName = d->bench.operatorName();
    askWhy(this, tr("Use this object"), [this, stated](const QString& reason) {
        authorize(d->bench, this, Permission::AcceptCalibrations,
                  [this, stated, reason] { storeReference(stated, reason); });
    });
}

void CalibrateCheck::storeReference(const ReferenceObject& stated, const QString& reason)
{
    d->bench.background().ask<CalibrationsInForce>(
        this,
        [stated, reason](Library& library) {
            return library.addReferenceObject(stated, reason).and_then([&] {
                return library.calibrationsInForce(stated.gripperSerial);
            });
        },
        [this, stated](const Expected<CalibrationsInForce>& standing) {
            if (!standing)
                return d->bench.messages().report(standing.error().describe());
            if (serial() == stated.gripperSerial)
                d->bench.connection().setCalibrations(*standing);
            d->bench.tellCalibrationChanged();
        });
}

} // namespace gripscope
