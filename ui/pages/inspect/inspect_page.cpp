// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect/inspect_page.h"

#include "core/base/words.h"
#include "ui/charts/type_map.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/inspect/inspect_automatic.h"
#include "ui/pages/inspect/inspect_batch.h"
#include "ui/pages/inspect/inspect_page_private.h"
#include "ui/pages/shared/example_types_button.h"
#include "ui/settings/values/settings.h"
#include "ui/sound/sound_player.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/fitted_label.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/widgets/outcome_view.h"
#include "ui/windows/scan_reader.h"
#include "ui/windows/stop_controls.h"
#include "ui/windows/window_guard.h"

#include <QApplication>
#include <QFocusEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <utility>

using namespace Qt::StringLiterals;

namespace gripscope {

InspectPage::InspectPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    d->expectedNow = bench.inspection().expectedType(); // of the window before this one
    auto* left = new QVBoxLayout;
    left->setSpacing(12);
    buildTop(left);
    buildVerdict(left);
    d->measurement = new InspectMeasurement(this);
    (new FitExporter(bench, this))->addFigure(d->measurement->findChild<TypeMap*>());
    left->addWidget(d->measurement, 4);
    buildActions(left);
    d->summary = new InspectSummary(bench, this);
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 16, 16);
    row->addLayout(left, 76);
    row->addWidget(d->summary, 24); // within the bounds that it has itself
    setFocusPolicy(Qt::StrongFocus);
    d->sounds = new SoundPlayer(this);
    d->sounds->setObjectName("inspectSounds");
    listenToPeople();
    connect(&bench, &Workbench::inspectionChanged, this, &InspectPage::refresh);
    connect(&bench, &Workbench::connectionChanged, this, &InspectPage::refresh);
    connect(&bench, &Workbench::ratesChanged, this, &InspectPage::refresh);
    connect(&StopStanding::of(bench), &StopStanding::changed, this, &InspectPage::refresh);
    connect(&bench.settings(), &Settings::changed, this, [this](const QString& key) {
        if (key != QLatin1String(setting::expectedType.key))
            refresh();
    });
    connect(&bench, &Workbench::ticked, this, &InspectPage::followTick);
    refresh();
}

InspectPage::~InspectPage()
{
    workbench().connection().removeListener(d->listener);
}

void InspectPage::listenToPeople()
{
    d->scans = new ScanReader(this);
    connect(d->scans, &ScanReader::scanned, this, &InspectPage::takeScan);
    connect(d->scans, &ScanReader::spacePressed, this, [this] {
        if (d->squeeze->isEnabled())
            squeeze();
    });
    d->listener = workbench().connection().addListener([this](const std::vector<Sample>& samples) {
        d->buttonPressed = d->button.pressedIn(samples) || d->buttonPressed;
    });
    connect(&workbench(), &Workbench::connectionChanged, this, [this] {
        if (workbench().connection().state() != ConnectSession::State::Connected)
            d->button.reset();
        d->notice.reset();
    });
    connect(&d->summary->batch(), &InspectBatch::expects, this, [this](const QString& type) {
        d->expected->setTypes(
            workbench().inspection().approvedTypes()); // it may be told before this page knows them
        d->expected->choose(type);
    });
    connect(&d->summary->batch(), &InspectBatch::whole, this, [this] { play(Sound::BatchWhole); });
    d->automatic = new InspectAutomatic(workbench(), this);
    connect(d->automatic, &InspectAutomatic::changed, this, &InspectPage::refresh);
    connect(d->automatic, &InspectAutomatic::due, this, [this] { (void)startSqueeze(); });
    // Whoever has switched verdicts off is warned all the same.
    connect(d->automatic, &InspectAutomatic::beat, this, [this] { d->sounds->play(Sound::Countdown); });
}

void InspectPage::followTick()
{
    // Outside the samples' own listeners, and for this page alone.
    if (std::exchange(d->buttonPressed, false) && d->active)
        takeButton();
    if (d->active && d->shownState != workbench().inspection().state())
        refresh();
    followAutomatic();
}

QString InspectPage::id() const
{
    return u"inspect"_s;
}

QString InspectPage::title() const
{
    return tr("Inspect");
}

QString InspectPage::iconName() const
{
    return u"answer-correct"_s;
}

void InspectPage::buildTop(QBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    auto* label = makeLabel(tr("Expected"), "strong", this);
    d->expected = new TypeChooser(this);
    d->expected->setObjectName("expectedCombo");
    label->setBuddy(d->expected);
    connect(d->expected, &TypeChooser::chosen, this, &InspectPage::expect);
    connect(d->expected, &TypeChooser::notFound, this, [this](const QString& text) {
        d->notice = unknownCodeHint(text, d->expected->expected());
        play(Sound::CodeUnknown);
        refresh();
        focusSqueeze();
    });
    d->recipe = new ElidedLabel({}, this);
    d->recipe->setObjectName("recipeLabel");
    setRole(d->recipe, "second");
    row->addWidget(label);
    row->addWidget(d->expected);
    d->part = new QLineEdit(this);
    d->part->setObjectName("partNumberField");
    d->part->setPlaceholderText(tr("part number"));
    d->part->setAccessibleName(tr("Number of the next part"));
    d->part->setToolTip(tr("Scan it anywhere on this page, or type it: kept with the next squeeze"));
    d->part->setMaxLength(longestPartNumber);
    d->part->setFixedWidth(112);
    connect(d->part, &QLineEdit::textEdited, this,
            [this](const QString& text) { workbench().inspection().setPartNumber(text.trimmed()); });
    connect(d->part, &QLineEdit::returnPressed, this, &InspectPage::focusSqueeze);
    row->addWidget(d->recipe, 1);
    QPushButton* rates = makeButton(tr("Rates…"), {}, "quiet", this);
    rates->setObjectName("ratesButton");
    rates->setFocusPolicy(Qt::TabFocus); // a click must not take Space from the squeeze
    connect(rates, &QPushButton::clicked, this, &InspectPage::editRates);
    row->addWidget(rates);
    auto* sound = new SoundButton(workbench().settings(), this);
    sound->setObjectName("soundButton");
    row->addWidget(sound);
    column->addLayout(row);
}

void InspectPage::buildVerdict(QBoxLayout* column)
{
    d->over = new FittedLabel(56, this);
    d->over->setObjectName("batchCompleteLabel");
    d->over->hide();
    column->addWidget(d->over);
    d->verdict = new VerdictPanel(this);
    d->verdict->setObjectName("verdictPanel");
    d->verdict->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    column->addWidget(d->verdict, 3);
    d->reason = new InspectReason(this);
    d->voidLast = makeButton(tr("Void…"), {}, "quiet", this);
    d->voidLast->setObjectName("voidButton");
    d->voidLast->setAccessibleName(tr("Void the last squeeze"));
    d->voidLast->setToolTip(
        tr("Squeezed twice, or nothing in the jaws: the last squeeze then counts nowhere"));
    d->voidLast->setFocusPolicy(Qt::TabFocus); // a click must not take Space from the squeeze
    connect(d->voidLast, &QPushButton::clicked, this, &InspectPage::askToVoid);
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(d->reason, 1);
    row->addWidget(d->voidLast, 0, Qt::AlignTop);
    column->addLayout(row);
    d->drift = makeLabel({}, "error", this);
    d->drift->setObjectName("driftLabel");
    d->drift->setWordWrap(true);
    d->drift->hide();
    column->addWidget(d->drift);
    d->adjustment = new ElidedLabel({}, this);
    setRole(d->adjustment, "caption");
    d->adjustment->setObjectName("adjustmentLabel");
    d->adjustment->hide();
    column->addWidget(d->adjustment);
}

void InspectPage::refreshDrift()
{
    const std::optional<DriftReport>& report = workbench().inspection().drift();
    const std::optional<Finding> drift = report ? driftSignal(*report) : std::nullopt;
    const std::optional<Finding>& chart = workbench().inspection().processSignal();
    // Of both one sentence: what has moved tells most; then the charts, whose limits somebody fixed.
    const bool moved = drift && report && !report->moved.isEmpty();
    const std::optional<Finding>& signal = moved || !chart ? drift : chart;
    const std::optional<AdjustmentStanding> adjustment = workbench().inspection().adjustment();
    QStringList told = adjustment ? described(adjustmentSignals(*adjustment)) : QStringList();
    if (signal)
        told.prepend(signal->describe());
    QStringList all;
    if (chart)
        all << chart->describe();
    if (drift)
        all << drift->describe() << described(report->words);
    d->drift->setVisible(!told.isEmpty());
    d->drift->setText(keptTogether(told.join(u' ')));
    d->drift->setToolTip(all.join(u'\n'));
    d->adjustment->setVisible(adjustment.has_value());
    if (adjustment)
        d->adjustment->setFullText(
            tr("Adjusted to the gripper of the types: %1.")
                .arg(adjustmentInWords(adjustment->record.adjustment.error).describe()));
}

void InspectPage::buildActions(QBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    d->squeeze = makeButton(tr("Squeeze (Space)"), u"media-playback-start"_s, "primary", this);
    d->squeeze->setObjectName("squeezeButton");
    d->squeeze->setProperty("large", true);
    connect(d->squeeze, &QPushButton::clicked, this, &InspectPage::squeeze);
    d->arm = makeButton(tr("Arm the gripper"), u"object-unlocked"_s, "primary", this);
    d->arm->setObjectName("inspectArmButton");
    d->arm->setProperty("large", true);
    connect(d->arm, &QPushButton::clicked, this, [this] { workbench().arm(); });
    row->addWidget(new ExampleTypesButton(workbench(), Examples::Cans, this));
    row->addWidget(d->arm, 2);
    row->addWidget(d->part); // here, since the row above has no room for it in every language
    row->addWidget(d->squeeze, 3);
    d->automaticWords = new ElidedLabel({}, this);
    d->automaticWords->setObjectName("automaticLabel");
    setRole(d->automaticWords, "caption");
    column->addWidget(d->automaticWords);
    column->addLayout(row);
}

void InspectPage::setActive(bool active)
{
    d->active = active;
    d->scans->setActive(active);
    d->automatic->setActive(active);
    workbench().inspection().setForecasting(active);
    if (!active)
        return;
    d->buttonPressed = false;
    refresh();
    focusSqueeze();
}

void InspectPage::focusSqueeze()
{
    if (!d->active) // the keys are another page's, and Space would squeeze from there
        return;
    if (d->squeeze->isEnabled())
        d->squeeze->setFocus();
    else if (d->arm->isVisible() && d->arm->isEnabled())
        d->arm->setFocus();
    else
        setFocus();
}

void InspectPage::focusInEvent(QFocusEvent* event)
{
    Page::focusInEvent(event);
    if (d->squeeze->isEnabled())
        d->squeeze->setFocus(event->reason());
}

void InspectPage::expect(const QString& type)
{
    const bool isNew = type != d->expectedNow;
    d->expectedNow = type;
    d->recalled = true; // of what was before, nothing is to come back
    workbench().inspection().setExpectedType(type);
    workbench().settings().set(setting::expectedType, type);
    d->summary->setExpected(type);
    d->notice.reset();
    if (isNew && workbench().inspection().result())
        d->notice = expectedHint(type); // the verdict that is shown was held against another
    refresh();
    focusSqueeze();
}

void InspectPage::squeeze()
{
    if (d->active && startSqueeze())
        d->automatic->squeezedByHand();
}

bool InspectPage::startSqueeze()
{
    if (workbench().busyWithSqueeze())
        return false;
    if (batchIsOver()) {
        askToGoOn();
        return false;
    }
    d->notice.reset();
    const Expected<void> started = workbench().inspection().squeeze();
    if (!started)
        workbench().messages().report(started.error().describe());
    refresh();
    return started.has_value();
}

void InspectPage::refresh()
{
    d->shownState = workbench().inspection().state();
    refreshExpected();
    refreshActions();
    refreshPart();
    refreshVerdict();
}

void InspectPage::refreshExpected()
{
    const std::vector<TypeRecord> types = workbench().inspection().approvedTypes();
    d->expected->setTypes(types);
    if (!d->recalled && !types.empty() && workbench().inspection().state() != InspectSession::State::Loading)
        recallExpected();
    if (d->expected->expected() != d->expectedNow &&
        workbench().inspection().state() != InspectSession::State::Loading)
        return forgetExpected();
    QStringList enrolled;
    for (const TypeRecord& type : types)
        enrolled << u"%1 %2"_s.arg(type.squeezes).arg(type.name);
    if (enrolled != d->shownTypes) {
        d->shownTypes = enrolled;
        d->measurement->setTypes(workbench().inspection().models(), !types.empty());
    }
    // The time first: it is what is looked for, and the rest gives way where there is no room.
    const InspectSession& session = workbench().inspection();
    const Recipe recipe = session.nextRecipe();
    QStringList parts{timeText(), recipe.name, pushText(recipe.bias_N, recipe.peak_N)};
    if (const auto& forecast = session.forecast(); session.earlyEnd() && forecast) {
        parts[0] = tr("at most %1 s").arg(Words::number(recipe.seconds, 'g', 3));
        parts.prepend(tr("about %1 s").arg(Words::number(forecast->mean_s, 'g', 2)));
    }
    d->recipe->setParts(parts, u" · "_s);
}

void InspectPage::refreshActions()
{
    ConnectSession& connection = workbench().connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const bool commandable = connection.identity().commandable;
    const bool ready = workbench().inspection().state() == InspectSession::State::Ready;
    const bool wasEnabled = d->squeeze->isEnabled();
    const bool keysAreOurs = isOurs(window()->focusWidget());
    const bool typing = d->expected->hasFocus() || d->part->hasFocus();
    const bool anyTypes = !workbench().inspection().approvedTypes().empty();
    d->arm->setVisible(anyTypes && !(connected && (connection.armed() || !commandable)));
    d->arm->setEnabled(connected);
    d->squeeze->setVisible(anyTypes); // there is nothing yet that a part could be
    d->squeeze->setEnabled(connected && ready && (connection.armed() || !commandable));
    switch (workbench().inspection().state()) {
    case InspectSession::State::Squeezing:
        d->squeeze->setText(tr("Squeezing…"));
        break;
    case InspectSession::State::Judging:
        d->squeeze->setText(tr("Judging…"));
        break;
    case InspectSession::State::Loading:
    case InspectSession::State::Ready:
        d->squeeze->setText(squeezeText(commandable || !connected));
        break;
    }
    // Hiding or disabling the focused button hands the focus on, to anything. It is kept here, and when the
    // next squeeze can begin (who armed it may have clicked elsewhere) it comes back: Space is enough.
    const bool nowEnabled = d->squeeze->isEnabled() && !wasEnabled;
    if (d->active && (keysAreOurs || (nowEnabled && !typing)))
        focusSqueeze();
}

bool InspectPage::isOurs(const QWidget* focused) const
{
    return !focused || focused == this || focused == d->squeeze || focused == d->arm;
}

QString InspectPage::squeezeText(bool commandable) const
{
    if (!commandable)
        return tr("Record (Space)");
    const auto& result = workbench().inspection().result();
    const bool again = result && (result->outcome == InspectionOutcome::NotValid ||
                                  result->outcome == InspectionOutcome::Inconclusive);
    return again && !callsSupervisor(*result, callAfter()) ? tr("Squeeze again (Space)")
                                                           : tr("Squeeze (Space)");
}

void InspectPage::refreshVerdict()
{
    InspectSession& session = workbench().inspection();
    const bool running = session.state() == InspectSession::State::Squeezing;
    d->verdict->setProgress(running ? session.progress() : -1);
    d->automaticWords->setVisible(d->automatic->wanted());
    d->automaticWords->setFullText(d->automatic->words());
    const auto& result = session.result();
    if (d->automatic->counting()) {
        if (result)
            d->past = result->squeeze; // another part is in the jaws
        d->automatic->show(*d->verdict);
    } else if (d->notice) {
        d->verdict->showHint(d->notice->headline, d->notice->words);
    } else if (result && !isPast(*result)) {
        const VerdictWords words = verdictWords(*result, callAfter());
        d->verdict->showOutcome(result->outcome, words.headline, words.outcome, isSuspect(*result));
    } else {
        const InspectHint hint =
            result ? pastHint(workbench(), timeText(), *result) : inspectHint(workbench(), timeText());
        d->verdict->showHint(hint.headline, hint.words);
    }
    // What was found of the last part is not said beside something else.
    static const std::optional<InspectSession::Result> none;
    const std::optional<InspectSession::Result>& shown =
        d->automatic->counting() || d->notice || (result && isPast(*result)) ? none : result;
    d->reason->showResult(shown ? &*shown : nullptr);
    d->reason->showRates(shown ? shown->rates : workbench().rates().rates);
    d->measurement->showResult(shown);
    refreshDrift();
    if (result && !StopStanding::of(workbench()).notObeyed())
        tellResult(*result);
}

/// Once the gripper was stopped or went away, or squeezes again, nobody knows what its jaws hold.
bool InspectPage::isPast(const InspectSession::Result& result)
{
    const StopStanding& standing = StopStanding::of(workbench());
    const InspectSession::State state = workbench().inspection().state();
    const bool squeezing =
        state == InspectSession::State::Squeezing || state == InspectSession::State::Judging;
    const ConnectSession::State link = workbench().connection().state();
    const bool away = link == ConnectSession::State::Lost || link == ConnectSession::State::Disconnected;
    if (squeezing || result.voided || standing.stopped() || standing.notObeyed() || away)
        d->past = result.squeeze;
    return d->past == result.squeeze;
}

void InspectPage::play(Sound sound)
{
    if (workbench().settings().get(setting::soundOnVerdict))
        d->sounds->play(sound);
}

void InspectPage::tellResult(const InspectSession::Result& result)
{
    if (result.squeeze != d->heard) {
        d->heard = result.squeeze;
        play(soundOf(result.outcome, isSuspect(result)));
    }
    if (result.number != 0 && result.number != d->shownNumber)
        workbench().navigator().setFitSubject(
            {tr("Inspection %1").arg(result.number), result.recording, result.identification});
    d->shownNumber = result.number;
}

QString InspectPage::timeText() const
{
    const InspectSession& session = workbench().inspection();
    const QString longest = Words::number(session.nextRecipe().seconds, 'g', 3);
    const auto& forecast = session.forecast();
    if (!session.earlyEnd())
        return tr("%1 s").arg(longest);
    if (!forecast)
        return tr("at most %1 s").arg(longest);
    return tr("about %1 s, at most %2 s").arg(Words::number(forecast->mean_s, 'g', 2), longest);
}

} // namespace gripscope
