// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live_page.h"

#include "core/session/squeeze_job.h"
#include "ui/connection_words.h"
#include "ui/page_state.h"
#include "ui/pages/live_channel_card.h"
#include "ui/pages/live_estimate_card.h"
#include "ui/pages/live_link_panel.h"
#include "ui/theme/theme.h"
#include "ui/tour_script.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QButtonGroup>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr int numbersEvery_ms = 200; ///< figures that change faster cannot be read
}

struct LivePage::Private {
    explicit Private(Workbench& workbench) : trial(workbench.connection()) {}

    SqueezeJob trial;
    bool trialRunning = false;
    bool openFit = true;
    int trials = 0;
    Recipe recipe;
    bool active = false, paused = false;
    double pausedAt_s = 0;
    QElapsedTimer sinceNumbers;
    LiveChannelCard* force = nullptr;
    LiveChannelCard* position = nullptr;
    LiveEstimateCard* estimate = nullptr;
    QButtonGroup* spans = nullptr;
    QPushButton* pause = nullptr;
    QPushButton* tare = nullptr;
    QPushButton* squeeze = nullptr;
    QProgressBar* progress = nullptr;
    QLabel* hint = nullptr;
    LiveLinkPanel* link = nullptr;
    TourScript tour;
};

LivePage::LivePage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>(bench))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    buildToolbar(column);
    buildCharts(column);
    d->link = new LiveLinkPanel(bench, this);
    connect(&d->force->chart(), &StripChart::painted, d->link, [this] {
        if (!d->paused)
            d->link->notePainted();
    });
    column->addWidget(d->link);
    setFocusPolicy(Qt::StrongFocus);
    d->sinceNumbers.start();
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

void LivePage::buildToolbar(QBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
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
    connect(d->spans, &QButtonGroup::idClicked, this, [this](int seconds) {
        d->force->chart().setSeconds(seconds);
        d->position->chart().setSeconds(seconds);
        refreshCharts();
    });
    row->addSpacing(8);
    d->pause = makeButton(tr("Pause"), u"media-playback-pause"_s, "", this);
    d->pause->setObjectName("pauseButton");
    d->pause->setCheckable(true);
    connect(d->pause, &QPushButton::toggled, this, [this](bool on) {
        d->paused = on;
        d->pausedAt_s = workbench().liveHistory().newestTime_s();
        d->pause->setText(on ? tr("Paused") : tr("Pause"));
    });
    d->tare = makeButton(tr("Tare"), {}, "", this);
    d->tare->setObjectName("tareButton");
    d->tare->setCheckable(true);
    d->tare->setToolTip(tr("Shows force and position from here on; what is recorded stays as it is"));
    connect(d->tare, &QPushButton::toggled, this, &LivePage::setTared);
    row->addWidget(d->pause);
    row->addWidget(d->tare);
    d->hint = makeLabel({}, "caption", this);
    d->hint->setWordWrap(true);
    d->hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addSpacing(8);
    row->addWidget(d->hint, 1);
    d->progress = new QProgressBar(this);
    d->progress->setTextVisible(false);
    d->progress->setMinimumWidth(120);
    d->progress->setAccessibleName(tr("Trial squeeze"));
    d->progress->hide();
    row->addWidget(d->progress, 1);
    d->squeeze = makeButton(tr("Trial squeeze"), u"media-playback-start"_s, "primary", this);
    d->squeeze->setObjectName("trialButton");
    connect(d->squeeze, &QPushButton::clicked, this, [this] {
        if (d->trialRunning)
            d->trial.cancel();
        else if (workbench().connection().armed() || !workbench().connection().identity().commandable)
            startTrial();
        else
            workbench().arm();
    });
    row->addWidget(d->squeeze);
    column->addLayout(row);
}

void LivePage::buildCharts(QBoxLayout* column)
{
    d->force = new LiveChannelCard(LiveHistory::Channel::Force, tr("Force"), this);
    d->position = new LiveChannelCard(LiveHistory::Channel::Position, tr("Position"), this);
    column->addWidget(d->force, 1);
    column->addWidget(d->position, 1);
    d->estimate = new LiveEstimateCard(this);
    column->addWidget(d->estimate);
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
        refreshCharts();
}

void LivePage::refresh()
{
    followTrial();
    if (!d->active)
        return;
    refreshCharts();
    if (d->sinceNumbers.elapsed() >= numbersEvery_ms) {
        d->sinceNumbers.restart();
        refreshNumbers();
    }
}

void LivePage::refreshCharts()
{
    const LiveHistory& history = workbench().liveHistory();
    const double until_s = d->paused ? d->pausedAt_s : history.newestTime_s();
    d->force->refreshChart(history, until_s);
    d->position->refreshChart(history, until_s);
}

void LivePage::refreshNumbers()
{
    const LiveHistory& history = workbench().liveHistory();
    const bool connected = workbench().connection().state() == ConnectSession::State::Connected;
    for (LiveChannelCard* card : {d->force, d->position}) {
        if (connected)
            card->refreshValue(history, history.newestTime_s());
        else
            card->showNoValue();
    }
    const GripperIdentity identity = workbench().connection().identity();
    const LiveEstimate& estimate = workbench().liveEstimate();
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
    const bool ready = connection.armed() || !identity.commandable;
    d->squeeze->setEnabled(connected);
    const ThemeTokens& tokens = Theme::instance().tokens();
    const auto offer = [&](const QString& text, const QString& icon) {
        d->squeeze->setText(text);
        d->squeeze->setAccessibleName(text);
        d->squeeze->setIcon(Theme::instance().icon(icon, Theme::onColor(tokens.accent)));
    };
    if (d->trialRunning)
        offer(tr("Cancel squeeze"), u"dialog-cancel"_s);
    else if (connected && !identity.commandable)
        offer(tr("Record 1 s"), u"media-playback-start"_s);
    else if (connected && !ready)
        offer(tr("Arm"), u"object-unlocked"_s);
    else
        offer(tr("Trial squeeze"), u"media-playback-start"_s);
    d->progress->setVisible(d->trialRunning);
    d->hint->setVisible(!d->trialRunning);
    if (!connected)
        d->hint->setText(
            u"%1. %2."_s.arg(missingWords(connection).headline, missingWords(connection).detail));
    else if (!identity.commandable)
        d->hint->setText(tr("This gripper only streams: squeeze by its own program, and record."));
    else if (!connection.armed())
        d->hint->setText(tr("Hands clear, then arm: a trial squeeze pushes with %1 ± %2 N for %3 s.")
                             .arg(d->recipe.bias_N)
                             .arg(d->recipe.peak_N)
                             .arg(d->recipe.seconds));
    else
        d->hint->setText(
            tr("Armed. The result of a trial squeeze opens on the Fit page; nothing is stored."));
}

void LivePage::setTared(bool on)
{
    const LiveHistory& history = workbench().liveHistory();
    for (LiveChannelCard* card : {d->force, d->position}) {
        const std::optional<double> mean = card->meanNow(history, history.newestTime_s());
        card->setZero(on && mean ? *mean : 0);
        card->refreshValue(history, history.newestTime_s());
    }
    d->tare->setText(on ? tr("Tared") : tr("Tare"));
    refreshCharts();
}

void LivePage::startTrial()
{
    if (workbench().squeezing()) {
        workbench().report(tr("Another squeeze is under way. Wait for its end, then try again."));
        return;
    }
    d->trial.setOperator(workbench().operatorName());
    const auto seed = static_cast<std::uint64_t>(d->trials + 1);
    const Expected<void> started = workbench().connection().identity().commandable
                                       ? d->trial.start(d->recipe, seed)
                                       : d->trial.listen(d->recipe.seconds);
    if (!started) {
        workbench().report(started.error().describe());
        return;
    }
    ++d->trials;
    d->trialRunning = true;
    workbench().setTrialRunning(true);
    refreshControls();
}

void LivePage::followTrial()
{
    if (!d->trialRunning)
        return;
    d->trial.poll();
    d->progress->setValue(static_cast<int>(100 * d->trial.progress()));
    if (d->trial.state() != SqueezeJob::State::Done && d->trial.state() != SqueezeJob::State::Failed)
        return;
    d->trialRunning = false;
    workbench().setTrialRunning(false);
    refreshControls();
    if (d->trial.state() == SqueezeJob::State::Failed) {
        workbench().report(d->trial.error()->describe());
        return;
    }
    const Recording recording = d->trial.recording();
    const QString name = tr("Trial squeeze %1").arg(d->trials);
    workbench().compute<Identification>(
        this, [recording] { return identify(recording); },
        [this, recording, name](const Identification& found) {
            FitSubject subject{name, recording, found};
            if (d->openFit)
                workbench().showInFit(std::move(subject));
            else
                workbench().setFitSubject(std::move(subject));
        });
}

void LivePage::prepareTour()
{
    d->openFit = false;
    TourScript& tour = d->tour;
    tour.connectTo(workbench(), u"virtual:?object=A&seed=11"_s);
    for (int i = 0; i < 2; ++i) {
        tour.add([this] { startTrial(); }, [this] { return !d->trialRunning; });
        tour.wait(900);
    }
    tour.add([this] { startTrial(); }, [this] { return d->trial.progress() > 0.6 || !d->trialRunning; });
    tour.start(workbench());
}

bool LivePage::tourReady() const
{
    return d->tour.done();
}

} // namespace gripscope
