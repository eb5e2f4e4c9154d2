// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live/live_page.h"

#include "core/base/words.h"
#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/format/shown_unit.h"
#include "ui/models/live_marker_model.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/live/live_cards.h"
#include "ui/pages/live/live_pause.h"
#include "ui/pages/live/live_recording.h"
#include "ui/pages/page_state.h"
#include "ui/pages/tour_script.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/tool_button.h"

#include <QButtonGroup>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QShortcut>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr int numbersEvery_ms = 200; ///< figures that change faster cannot be read
}

struct LivePage::Private {
    LiveMarkerModel markers;
    int beginnings = 0; ///< of the history that the markers belong to
    bool active = false;
    QElapsedTimer sinceNumbers;
    LiveTrial* trial = nullptr;
    LivePause* pause = nullptr;
    LiveSave* save = nullptr;
    LiveChannelCard* force = nullptr;
    LiveChannelCard* position = nullptr;
    LiveEstimateCard* estimate = nullptr;
    QButtonGroup* spans = nullptr;
    QPushButton* hold = nullptr;
    QPushButton* tare = nullptr;
    QToolButton* marker = nullptr;
    QPushButton* squeeze = nullptr;
    QProgressBar* progress = nullptr;
    QLabel* hint = nullptr;
    QWidget* hintLine = nullptr; ///< hint or progress
    LiveLinkPanel* link = nullptr;
    TourScript tour;
};

LivePage::LivePage(Workbench& bench, QWidget* parent) : Page(bench, parent), d(std::make_unique<Private>())
{
    d->trial = new LiveTrial(bench, d->markers, this);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    auto* toolbar = new QHBoxLayout;
    toolbar->setSpacing(8);
    column->addLayout(toolbar);
    buildHint(column);
    buildCharts(column);
    d->link = new LiveLinkPanel(bench, this);
    connect(&d->force->chart(), &StripChart::painted, d->link, [this] {
        if (!d->pause->held())
            d->link->notePainted();
    });
    auto* exporter = new FitExporter(bench, this);
    for (StripChart* chart : {&d->force->chart(), &d->position->chart()})
        exporter->addFigure(chart); // its context menu
    column->addWidget(d->link);
    buildPause(column);
    buildToolbar(toolbar);
    makeShortcuts();
    setFocusPolicy(Qt::StrongFocus);
    d->sinceNumbers.start();
    connect(d->trial, &LiveTrial::changed, this, &LivePage::refreshControls);
    connect(&bench, &Workbench::ticked, this, &LivePage::refresh);
    connect(&bench, &Workbench::connectionChanged, this, &LivePage::refreshControls);
    refreshControls();
}

LivePage::~LivePage() = default;

QString LivePage::id() const
{
    return u"live"_s;
}

QString LivePage::title() const
{
    return tr("Live");
}

QString LivePage::iconName() const
{
    return u"office-chart-line"_s;
}

void LivePage::buildToolbar(QBoxLayout* row)
{
    addSpans(row);
    row->addSpacing(8);
    d->hold = makeButton(tr("Pause"), u"media-playback-pause"_s, "", this);
    d->hold->setObjectName("pauseButton");
    d->hold->setCheckable(true);
    d->hold->setToolTip(tr("Holds the charts, to zoom, move and measure in them; measuring goes on"));
    connect(d->hold, &QPushButton::toggled, this, &LivePage::setHeld);
    d->tare = makeButton(tr("Tare"), {}, "", this);
    d->tare->setObjectName("tareButton");
    d->tare->setCheckable(true);
    d->tare->setToolTip(tr("Shows force and position from here on; what is recorded stays as it is"));
    connect(d->tare, &QPushButton::toggled, this, &LivePage::setTared);
    d->marker = makeToolButton({}, u"flag"_s,
                               tr("Drop a marker (M): at the newest sample, or at the cursor moved last"));
    d->marker->setObjectName("markerButton");
    d->marker->setFixedHeight(metrics::touchTarget);
    connect(d->marker, &QToolButton::clicked, this, &LivePage::dropMarker);
    row->addWidget(d->hold);
    row->addWidget(d->tare);
    row->addWidget(d->marker);
    row->addStretch(1);
    d->squeeze = makeButton(tr("Trial squeeze"), u"media-playback-start"_s, "primary", this);
    d->squeeze->setObjectName("trialButton");
    connect(d->squeeze, &QPushButton::clicked, this, [this] {
        if (d->trial->running())
            d->trial->cancel();
        else if (workbench().connection().armed() || !workbench().connection().identity().commandable)
            d->trial->start();
        else
            workbench().arm();
    });
    row->addWidget(d->squeeze);
}

void LivePage::buildHint(QBoxLayout* column)
{
    // One line of the same height for both: the charts stay where they are when a squeeze starts.
    d->hintLine = new QWidget(this);
    d->hintLine->setMinimumHeight(20);
    auto* row = new QHBoxLayout(d->hintLine);
    setSpacing(row, 0, 0);
    d->hint = makeLabel({}, "caption", this);
    d->hint->setWordWrap(true);
    d->progress = new QProgressBar(this);
    d->progress->setTextVisible(false);
    d->progress->setAccessibleName(tr("Trial squeeze"));
    d->progress->hide();
    row->addWidget(d->hint);
    row->addWidget(d->progress);
    column->addWidget(d->hintLine);
}

void LivePage::addSpans(QBoxLayout* row)
{
    d->spans = new QButtonGroup(this);
    d->spans->setExclusive(true);
    const std::pair<QString, int> choices[] = {
        {tr("2 s"), 2}, {tr("10 s"), 10}, {tr("1 min"), 60}, {tr("10 min"), 600}};
    for (const auto& [text, seconds] : choices) {
        QPushButton* button = makeButton(text, {}, "", this);
        button->setCheckable(true);
        button->setChecked(seconds == 10);
        button->setAccessibleName(tr("Show the last %1").arg(text));
        button->setObjectName(u"span-%1"_s.arg(seconds));
        rememberChoice(button);
        d->spans->addButton(button, seconds);
        row->addWidget(button);
    }
    connect(d->spans, &QButtonGroup::idClicked, this, [this](int seconds) { d->pause->setSpan(seconds); });
}

void LivePage::buildCharts(QBoxLayout* column)
{
    d->force = new LiveChannelCard(LiveHistory::Channel::Force, tr("Force"), this);
    d->position = new LiveChannelCard(LiveHistory::Channel::Position, tr("Position"), this);
    d->force->chart().setTimeLabels(false); // the same time stands below the other chart
    column->addWidget(d->force, 1);
    column->addWidget(d->position, 1);
    d->estimate = new LiveEstimateCard(this);
    column->addWidget(d->estimate);
}

void LivePage::buildPause(QBoxLayout* column)
{
    d->pause = new LivePause(workbench(), *d->force, *d->position, d->markers, this);
    d->save = new LiveSave(workbench(), this);
    column->addWidget(&d->pause->panel());
    connect(d->pause, &LivePause::saveAsked, this,
            [this] { d->save->ask(d->pause->recordingInView(), d->pause->view().seconds()); });
    connect(d->save, &LiveSave::writing, &d->pause->panel(), &LiveMeasurePanel::setSaving);
}

void LivePage::makeShortcuts()
{
    const auto add = [this](const QList<QKeySequence>& keys, auto action) {
        auto* shortcut = new QShortcut(this);
        shortcut->setKeys(keys);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, action);
    };
    add({Qt::Key_M}, [this] { dropMarker(); });
    add({Qt::Key_Plus, Qt::Key_Equal}, [this] { d->pause->zoom(2); });
    add({Qt::Key_Minus}, [this] { d->pause->zoom(0.5); });
    add({Qt::Key_Home}, [this] { d->pause->reset(); });
}

void LivePage::setActive(bool active)
{
    d->active = active;
    if (active) {
        refresh();
        d->squeeze->isEnabled() ? d->squeeze->setFocus() : setFocus();
    }
}

void LivePage::resizeEvent(QResizeEvent* event)
{
    Page::resizeEvent(event);
    if (d->active)
        d->pause->refreshCharts();
}

void LivePage::refresh()
{
    d->trial->follow();
    d->progress->setValue(static_cast<int>(100 * d->trial->progress()));
    if (!d->pause->held() && d->beginnings != workbench().live().history().beginnings()) {
        d->beginnings = workbench().live().history().beginnings();
        d->markers.clear(); // their times are those of another history
    }
    if (!d->active)
        return;
    if (!d->pause->held())
        d->pause->refreshCharts();
    if (d->sinceNumbers.elapsed() >= numbersEvery_ms) {
        d->sinceNumbers.restart();
        refreshNumbers();
    }
}

void LivePage::setHeld(bool on)
{
    d->hold->setText(on ? tr("Paused") : tr("Pause"));
    d->hintLine->setVisible(!on); // cursors and readings need the room
    d->estimate->setVisible(!on);
    d->link->setVisible(!on);
    d->pause->setHeld(on);
    if (on)
        d->force->chart().setFocus(); // for the arrows
}

void LivePage::dropMarker()
{
    if (d->pause->history().empty())
        workbench().messages().report(tr("A marker needs something measured. Connect a gripper first."));
    else
        d->markers.add(d->pause->marker());
}

void LivePage::refreshNumbers()
{
    const LiveHistory& history = workbench().live().history();
    const bool connected = workbench().connection().state() == ConnectSession::State::Connected;
    for (LiveChannelCard* card : {d->force, d->position}) {
        if (connected)
            card->refreshValue(history, history.newestTime_s());
        else
            card->showNoValue();
    }
    const GripperIdentity identity = workbench().connection().identity();
    const LiveEstimate& estimate = workbench().live().estimate();
    d->estimate->show(estimate.state(), estimate.following(), identity.forceUnit, identity.positionUnit);
    d->link->refresh();
}

void LivePage::refreshControls()
{
    ConnectSession& connection = workbench().connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const GripperIdentity identity = connection.identity();
    d->force->setDeviceUnit(identity.forceUnit);
    d->position->setDeviceUnit(identity.positionUnit);
    d->force->setCommandable(identity.commandable);
    const bool ready = connection.armed() || !identity.commandable;
    d->squeeze->setEnabled(connected);
    const ThemeTokens& tokens = Theme::instance().tokens();
    const auto offer = [&](const QString& text, const QString& icon) {
        d->squeeze->setText(text);
        d->squeeze->setAccessibleName(text);
        d->squeeze->setIcon(Theme::instance().icon(icon, Theme::onColor(tokens.accent)));
    };
    if (d->trial->running())
        offer(tr("Cancel squeeze"), u"dialog-cancel"_s);
    else if (connected && !identity.commandable)
        offer(tr("Record 1 s"), u"media-playback-start"_s);
    else if (connected && !ready)
        offer(tr("Arm"), u"object-unlocked"_s);
    else
        offer(tr("Trial squeeze"), u"media-playback-start"_s);
    d->progress->setVisible(d->trial->running());
    d->hint->setVisible(!d->trial->running());
    if (!connected)
        d->hint->setText(
            u"%1. %2."_s.arg(missingWords(connection).headline, missingWords(connection).detail));
    else if (!identity.commandable)
        d->hint->setText(tr("This gripper only streams: squeeze by its own program, and record."));
    else if (!connection.armed())
        d->hint->setText(tr("Hands clear, then arm: a trial squeeze pushes with %1 for %2 s.")
                             .arg(pushText(d->trial->recipe().bias_N, d->trial->recipe().peak_N),
                                  Words::number(d->trial->recipe().seconds)));
    else
        d->hint->setText(
            tr("Armed. The result of a trial squeeze opens on the Fit page; nothing is stored."));
}

void LivePage::setTared(bool on)
{
    const LiveHistory& history = workbench().live().history();
    for (LiveChannelCard* card : {d->force, d->position}) {
        const std::optional<double> mean = card->meanNow(history, history.newestTime_s());
        card->setZero(on && mean ? *mean : 0);
        card->refreshValue(history, history.newestTime_s());
    }
    d->tare->setText(on ? tr("Tared") : tr("Tare"));
    d->pause->refreshCharts();
}

void LivePage::prepareTour()
{
    d->trial->setOpenFit(false);
    TourScript& tour = d->tour;
    tour.connectTo(workbench(), u"virtual:?object=A&seed=11"_s);
    for (int i = 0; i < 2; ++i) {
        tour.add([this] { d->trial->start(); }, [this] { return !d->trial->running(); });
        tour.wait(900);
    }
    tour.add([this] { d->trial->start(); },
             [this] { return d->trial->progress() > 0.6 || !d->trial->running(); });
    tour.start(workbench());
}

bool LivePage::tourReady() const
{
    return d->tour.done();
}

} // namespace gripscope
