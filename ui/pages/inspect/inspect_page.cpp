// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect/inspect_page.h"

#include "core/base/words.h"
#include "core/session/connection/device_button.h"
#include "ui/context/workbench.h"
#include "ui/format/outcome_words.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/inspect/inspect_batch.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/pages/shared/example_types_button.h"
#include "ui/pages/tour_script.h"
#include "ui/people/authorize.h"
#include "ui/settings/values/settings.h"
#include "ui/sound/sound_player.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/widgets/outcome_view.h"
#include "ui/windows/scan_reader.h"
#include "ui/windows/stop_controls.h"
#include "ui/windows/window_guard.h"

#include <QApplication>
#include <QFocusEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>

using namespace Qt::StringLiterals;

namespace gripscope {

struct InspectPage::Private {
    TypeChooser* expected = nullptr;
    ElidedLabel* recipe = nullptr;
    VerdictPanel* verdict = nullptr;
    InspectReason* reason = nullptr;
    InspectMeasurement* measurement = nullptr;
    QString expectedNow;
    QStringList shownTypes; ///< names and how many squeezes
    QPushButton *squeeze = nullptr, *arm = nullptr;
    InspectSummary* summary = nullptr;
    ScanReader* scans = nullptr;
    SoundPlayer* sounds = nullptr;
    int listener = 0;
    ButtonWatch button;
    bool buttonPressed = false;
    std::optional<InspectHint> notice; ///< of a code or a button; until something else happens
    bool active = false;
    std::optional<std::uint64_t> past; ///< the squeeze whose verdict is no longer about the part in the jaws
    qint64 shownNumber = 0;
    std::uint64_t heard = 0; ///< the squeeze whose verdict was heard
    InspectSession::State shownState = InspectSession::State::Loading;
    TourScript tour;
};

InspectPage::InspectPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    auto* left = new QVBoxLayout;
    left->setSpacing(12);
    buildTop(left);
    buildVerdict(left);
    d->measurement = new InspectMeasurement(this);
    left->addWidget(d->measurement, 4);
    buildActions(left);
    d->summary = new InspectSummary(bench, this);
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 16, 16);
    row->addLayout(left, 1);
    row->addWidget(d->summary);
    setFocusPolicy(Qt::StrongFocus);
    d->sounds = new SoundPlayer(this);
    d->sounds->setObjectName("inspectSounds");
    listenToPeople();
    connect(&bench, &Workbench::inspectionChanged, this, &InspectPage::refresh);
    connect(&bench, &Workbench::connectionChanged, this, &InspectPage::refresh);
    connect(&bench, &Workbench::ratesChanged, this, &InspectPage::refresh);
    connect(&StopStanding::of(bench), &StopStanding::changed, this, &InspectPage::refresh);
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
    connect(d->scans, &ScanReader::scanned, d->expected, &TypeChooser::choose);
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
        d->expected->setTypes(workbench().inspection().types()); // it may be told before this page knows them
        d->expected->choose(type);
    });
    connect(&d->summary->batch(), &InspectBatch::whole, this, [this] { play(Sound::BatchWhole); });
}

void InspectPage::followTick()
{
    // Outside the samples' own listeners, and for this page alone.
    if (std::exchange(d->buttonPressed, false) && d->active)
        takeButton();
    if (d->active && d->shownState != workbench().inspection().state())
        refresh();
}

void InspectPage::takeButton()
{
    const bool attended = isVisible() && !window()->isMinimized() && !WindowGuard::asking();
    const bool busy =
        workbench().squeezing() || workbench().inspection().state() != InspectSession::State::Ready;
    if (!attended || busy) // one press, one squeeze: a press during it is not kept
        return;
    if (d->squeeze->isEnabled())
        return squeeze();
    d->notice = buttonHint();
    refresh();
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
    d->expected->setMinimumWidth(200);
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
    d->verdict = new VerdictPanel(this);
    d->verdict->setObjectName("verdictPanel");
    d->verdict->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    column->addWidget(d->verdict, 3);
    d->reason = new InspectReason(this);
    column->addWidget(d->reason);
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
    row->addWidget(new ExampleTypesButton(workbench(), this));
    row->addWidget(d->arm, 2);
    row->addWidget(d->squeeze, 3);
    column->addLayout(row);
}

void InspectPage::setActive(bool active)
{
    d->active = active;
    d->scans->setActive(active);
    workbench().inspection().setForecasting(active);
    if (!active)
        return;
    d->buttonPressed = false;
    refresh();
    focusSqueeze();
}

void InspectPage::focusSqueeze()
{
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
    workbench().inspection().setExpectedType(type);
    d->summary->setExpected(type);
    d->notice.reset();
    if (isNew && workbench().inspection().result())
        d->notice = expectedHint(type); // the verdict that is shown was held against another
    refresh();
    focusSqueeze();
}

void InspectPage::squeeze()
{
    if (workbench().busyWithSqueeze())
        return;
    d->notice.reset();
    if (const Expected<void> started = workbench().inspection().squeeze(); !started)
        workbench().messages().report(started.error().describe());
    refresh();
}

void InspectPage::refresh()
{
    d->shownState = workbench().inspection().state();
    refreshExpected();
    refreshActions();
    refreshVerdict();
    d->reason->showRates(workbench().rates().rates);
}

void InspectPage::refreshExpected()
{
    const std::vector<TypeRecord>& types = workbench().inspection().types();
    d->expected->setTypes(types);
    if (d->expected->expected() != d->expectedNow &&
        workbench().inspection().state() != InspectSession::State::Loading)
        return expect(d->expected->expected()); // the type that was expected is gone
    QStringList enrolled;
    Recipe recipe;
    for (const TypeRecord& type : types) {
        enrolled << u"%1 %2"_s.arg(type.squeezes).arg(type.name);
        if (type.name == d->expectedNow)
            recipe = type.recipe;
    }
    if (enrolled != d->shownTypes) {
        d->shownTypes = enrolled;
        d->measurement->setTypes(workbench().inspection().models());
    }
    // The time first: it is what is looked for, and the rest gives way where there is no room.
    d->recipe->setParts({timeText(), recipe.name, pushText(recipe.bias_N, recipe.peak_N)}, u" · "_s);
}

void InspectPage::refreshActions()
{
    ConnectSession& connection = workbench().connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const bool commandable = connection.identity().commandable;
    const bool ready = workbench().inspection().state() == InspectSession::State::Ready;
    const bool wasEnabled = d->squeeze->isEnabled();
    const bool keysAreOurs = isOurs(window()->focusWidget());
    const bool typing = d->expected->hasFocus();
    const bool anyTypes = !workbench().inspection().types().empty();
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
    return again ? tr("Squeeze again (Space)") : tr("Squeeze (Space)");
}

void InspectPage::refreshVerdict()
{
    InspectSession& session = workbench().inspection();
    const bool running = session.state() == InspectSession::State::Squeezing;
    d->verdict->setProgress(running ? session.progress() : -1);
    const auto& result = session.result();
    if (d->notice) {
        d->verdict->showHint(d->notice->headline, d->notice->words);
    } else if (result && !isPast(*result)) {
        const VerdictWords words = verdictWords(*result);
        d->verdict->showOutcome(result->outcome, words.headline, words.outcome, isSuspect(*result));
    } else {
        const InspectHint hint =
            result ? pastHint(workbench(), timeText(), *result) : inspectHint(workbench(), timeText());
        d->verdict->showHint(hint.headline, hint.words);
    }
    // What was found of the last part is not said beside something else.
    static const std::optional<InspectSession::Result> none;
    const std::optional<InspectSession::Result>& shown =
        d->notice || (result && isPast(*result)) ? none : result;
    d->reason->showResult(shown ? &*shown : nullptr);
    d->measurement->showResult(shown);
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
    if (squeezing || standing.stopped() || standing.notObeyed() ||
        workbench().connection().state() == ConnectSession::State::Lost)
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

void InspectPage::editRates()
{
    const StoredRates now = workbench().rates();
    auto* dialog = new RatesDialog(now.rates, now.earlyEnd, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        changeRates(workbench(), this, {dialog->rates(), dialog->earlyEnd()});
    });
    dialog->open();
}

QString InspectPage::timeText() const
{
    const InspectSession& session = workbench().inspection();
    const QString longest = Words::number(session.longestSeconds(), 'g', 3);
    const auto& forecast = session.forecast();
    if (!session.earlyEnd())
        return tr("%1 s").arg(longest);
    if (!forecast)
        return tr("at most %1 s").arg(longest);
    return tr("about %1 s, at most %2 s").arg(Words::number(forecast->mean_s, 'g', 2), longest);
}

void InspectPage::prepareTour()
{
    // The batch of the picture, then parts for it.
    d->tour.add(
        [this] {
            d->expected->choose(u"A"_s);
            workbench().inspection().beginBatch({u"4711"_s, 400, u"A"_s, {}});
        },
        [this] { return workbench().inspection().batch().has_value(); });
    addInspections(
        d->tour, workbench(), [this] { d->expected->choose(u"A"_s); }, [this] { squeeze(); });
    d->tour.start(workbench());
}

bool InspectPage::tourReady() const
{
    return d->tour.done();
}

} // namespace gripscope
