// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect_page.h"

#include "core/words.h"
#include "ui/connection_words.h"
#include "ui/example_types_button.h"
#include "ui/pages/inspect_measurement.h"
#include "ui/pages/inspect_summary.h"
#include "ui/rates_dialog.h"
#include "ui/theme/theme.h"
#include "ui/tour_script.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/number_format.h"
#include "ui/widgets/outcome_view.h"
#include "ui/widgets/verdict_panel.h"
#include "ui/workbench.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

struct InspectPage::Private {
    QComboBox* expected = nullptr;
    ElidedLabel* recipe = nullptr;
    VerdictPanel* verdict = nullptr;
    ElidedLabel *facts = nullptr, *rates = nullptr;
    QLabel* reason = nullptr;
    InspectMeasurement* measurement = nullptr;
    QStringList shownTypes; ///< names and how many squeezes
    QPushButton *squeeze = nullptr, *arm = nullptr;
    InspectSummary* summary = nullptr;
    bool active = false;
    qint64 shownNumber = 0;
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

    connect(&bench, &Workbench::inspectionChanged, this, &InspectPage::refresh);
    connect(&bench, &Workbench::connectionChanged, this, &InspectPage::refresh);
    connect(&bench, &Workbench::ratesChanged, this, &InspectPage::refresh);
    connect(&bench, &Workbench::ticked, this, [this] {
        if (d->active && d->shownState != workbench().inspection().state())
            refresh();
    });
    refresh();
}

InspectPage::~InspectPage() = default;

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
    d->expected = new QComboBox(this);
    d->expected->setObjectName("expectedCombo");
    d->expected->setAccessibleName(tr("Expected type"));
    d->expected->setMinimumWidth(200);
    d->expected->addItem(tr("nothing expected"), QString());
    label->setBuddy(d->expected);
    connect(d->expected, &QComboBox::activated, this, [this] {
        workbench().inspection().setExpectedType(d->expected->currentData().toString());
        d->summary->setExpected(d->expected->currentData().toString());
        refreshExpected();
        d->squeeze->setFocus();
    });
    d->recipe = new ElidedLabel({}, this);
    d->recipe->setObjectName("recipeLabel");
    setRole(d->recipe, "second");
    row->addWidget(label);
    row->addWidget(d->expected);
    row->addWidget(d->recipe, 1);
    QPushButton* rates = makeButton(tr("Rates…"), {}, "quiet", this);
    rates->setObjectName("ratesButton");
    connect(rates, &QPushButton::clicked, this, &InspectPage::editRates);
    row->addWidget(rates);
    column->addLayout(row);
}

void InspectPage::buildVerdict(QBoxLayout* column)
{
    d->verdict = new VerdictPanel(this);
    d->verdict->setObjectName("verdictPanel");
    d->verdict->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    column->addWidget(d->verdict, 3);
    d->facts = new ElidedLabel({}, this);
    setRole(d->facts, "strong");
    d->rates = new ElidedLabel({}, this);
    d->rates->setObjectName("ratesLabel");
    setRole(d->rates, "caption");
    d->reason = makeLabel({}, "", this);
    d->reason->setObjectName("reasonLabel");
    d->reason->setWordWrap(true);
    d->reason->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    d->facts->hide();
    d->reason->hide();
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(d->facts);
    words->addWidget(d->reason);
    words->addWidget(d->rates);
    column->addLayout(words);
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
    workbench().inspection().setForecasting(active);
    if (!active)
        return;
    refresh();
    (d->squeeze->isEnabled() ? d->squeeze : d->arm)->setFocus();
}

void InspectPage::keyPressEvent(QKeyEvent* event)
{
    // A focused button, list or field takes Space for itself; here arrives what nothing else wanted.
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat() && d->squeeze->isEnabled()) {
        squeeze();
        return;
    }
    Page::keyPressEvent(event);
}

void InspectPage::squeeze()
{
    if (workbench().squeezing()) {
        workbench().report(tr("Another squeeze is under way. Wait for its end, then try again."));
        return;
    }
    if (const Expected<void> started = workbench().inspection().squeeze(); !started)
        workbench().report(started.error().describe());
    refresh();
}

void InspectPage::refresh()
{
    d->shownState = workbench().inspection().state();
    refreshExpected();
    refreshActions();
    refreshVerdict();
    refreshRates();
}

void InspectPage::refreshExpected()
{
    QStringList wanted{QString()};
    const std::vector<TypeRecord>& types = workbench().inspection().types();
    for (const TypeRecord& type : types)
        wanted << type.name;
    QStringList shown;
    for (int i = 0; i < d->expected->count(); ++i)
        shown << d->expected->itemData(i).toString();
    if (wanted != shown) {
        const QString kept = d->expected->currentData().toString();
        d->expected->clear();
        for (const QString& name : wanted)
            d->expected->addItem(name.isEmpty() ? tr("nothing expected") : name, name);
        d->expected->setCurrentIndex(std::max(0, d->expected->findData(kept)));
    }
    QStringList enrolled;
    for (const TypeRecord& type : types)
        enrolled << u"%1 %2"_s.arg(type.squeezes).arg(type.name);
    if (enrolled != d->shownTypes) {
        d->shownTypes = enrolled;
        d->measurement->setTypes(workbench().inspection().models());
    }
    const QString expected = d->expected->currentData().toString();
    Recipe recipe;
    for (const TypeRecord& type : types)
        if (type.name == expected)
            recipe = type.recipe;
    // The time first: it is what is looked for, and the end is cut where there is no room.
    d->recipe->setFullText(
        tr("%1 · %2, %3 ± %4 N").arg(timeText(), recipe.name).arg(recipe.bias_N).arg(recipe.peak_N));
}

void InspectPage::refreshActions()
{
    ConnectSession& connection = workbench().connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const bool commandable = connection.identity().commandable;
    const bool ready = workbench().inspection().state() == InspectSession::State::Ready;
    d->arm->setVisible(!(connected && (connection.armed() || !commandable)));
    d->arm->setEnabled(connected);
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
        d->squeeze->setText(commandable || !connected ? tr("Squeeze (Space)") : tr("Record (Space)"));
        break;
    }
    // Disabling the focused button hands the focus on: keep it here, so that Space works for the next part.
    if (d->active && !d->squeeze->isEnabled() && !d->arm->isVisible())
        setFocus();
}

void InspectPage::refreshVerdict()
{
    InspectSession& session = workbench().inspection();
    const bool running = session.state() == InspectSession::State::Squeezing;
    d->verdict->setProgress(running ? session.progress() : -1);
    const auto& result = session.result();
    if (!result) {
        showHint();
    } else {
        const VerdictWords words = verdictWords(*result);
        d->verdict->showOutcome(result->outcome, words.headline, words.outcome);
        if (result->number != 0 && result->number != d->shownNumber)
            workbench().setFitSubject(
                {tr("Inspection %1").arg(result->number), result->recording, result->identification});
        d->shownNumber = result->number;
    }
    showFacts();
}

void InspectPage::showHint()
{
    ConnectSession& connection = workbench().connection();
    InspectSession& session = workbench().inspection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    if (session.state() == InspectSession::State::Squeezing)
        d->verdict->showHint(tr("Squeezing…"), tr("Esc or STOP ends it at once"));
    else if (session.state() == InspectSession::State::Judging)
        d->verdict->showHint(tr("Judging…"), {});
    else if (session.state() == InspectSession::State::Loading)
        d->verdict->showHint(tr("Reading the library…"), {});
    else if (!connected)
        d->verdict->showHint(missingWords(connection).headline, missingWords(connection).detail);
    else if (session.types().empty())
        d->verdict->showHint(tr("No types yet"), tr("Enroll at least one type (Ctrl+3), then inspect parts"));
    else if (!connection.armed() && connection.identity().commandable)
        d->verdict->showHint(tr("Not armed"), tr("Place the part, hands clear, then arm the gripper"));
    else
        d->verdict->showHint(tr("Ready"), tr("Place the part, then squeeze: %1").arg(timeText()));
}

void InspectPage::showFacts()
{
    const auto& result = workbench().inspection().result();
    d->measurement->showResult(result);
    if (!result) {
        // Their room stays from the first verdict on, so that nothing jumps while the next squeeze runs.
        d->facts->setFullText(u" "_s);
        d->reason->clear();
        return;
    }
    // What to do about a bad measurement may take two lines and has no facts beside it.
    const bool valid = result->outcome != InspectionOutcome::NotValid;
    d->facts->setVisible(valid);
    d->reason->show();
    const Verdict& verdict = result->verdict;
    QStringList facts;
    const QString of = verdict.type.isEmpty() ? verdict.nearest : verdict.type;
    if (valid && !of.isEmpty()) {
        if (verdict.posterior.contains(of) && result->outcome != InspectionOutcome::Unknown)
            facts << tr("posterior of %1: %2").arg(of, formatProbability(verdict.posterior.value(of)));
        if (verdict.distance && verdict.gate)
            facts << tr("%1 sd from %2 (gate %3 sd)")
                         .arg(Words::number(std::sqrt(*verdict.distance), 'f', 1), of,
                              Words::number(std::sqrt(*verdict.gate), 'f', 1));
    }
    if (result->earlyEnd)
        facts << tr("decided after %1 s")
                     .arg(Words::number(static_cast<double>(result->earlyEnd->samples) *
                                            result->recording.sampleTime_s,
                                        'g', 2));
    d->facts->setFullText(facts.isEmpty() ? u" "_s : facts.join(u"  ·  "_s));
    d->reason->setText(verdictWords(*result).reason);
    d->reason->setToolTip(verdict.reasons.join(u' '));
}

void InspectPage::editRates()
{
    const StoredRates now = workbench().rates();
    auto* dialog = new RatesDialog(now.rates, now.earlyEnd, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        workbench().setRates({dialog->rates(), dialog->earlyEnd()});
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

void InspectPage::refreshRates()
{
    const VerdictOptions rates = workbench().rates().rates;
    d->rates->setFullText(tr("Held to: false-reject %1 (%2), wrong-type %3, stranger-accept %4")
                              .arg(formatRate(rates.falseReject),
                                   rates.confidence
                                       ? tr("with %1 confidence").arg(formatRate(*rates.confidence))
                                       : tr("on average"),
                                   formatRate(rates.wrongType), formatRate(rates.strangerAccept)));
}

void InspectPage::prepareTour()
{
    TourScript& tour = d->tour;
    const auto inspect = [this, &tour](int times) {
        for (int i = 0; i < times; ++i)
            tour.add([this] { squeeze(); },
                     [this] {
                         const InspectSession& session = workbench().inspection();
                         if (session.state() != InspectSession::State::Ready)
                             return false;
                         // A busy machine may have starved the gripper's heartbeat: as a person would, once
                         // more.
                         if (!session.result() && !workbench().connection().armed())
                             workbench().arm();
                         else if (!session.result())
                             squeeze();
                         return session.result() && session.result()->number != 0;
                     });
    };
    tour.add(
        [this] {
            workbench().inspection().setExpectedType(u"A"_s);
            d->expected->setCurrentIndex(std::max(0, d->expected->findData(u"A"_s)));
        },
        [this] { return workbench().inspection().state() == InspectSession::State::Ready; });
    tour.connectTo(workbench(), u"virtual:?object=A&seed=21"_s);
    inspect(3);
    tour.connectTo(workbench(), u"virtual:?object=B&seed=22"_s);
    inspect(1);
    // A can that nobody enrolled: between the others in stiffness, with a damping of its own.
    tour.connectTo(workbench(), u"virtual:?object=0.05,80,7000&seed=23"_s);
    inspect(1);
    tour.connectTo(workbench(), u"virtual:?object=A&seed=24"_s);
    inspect(1);
    tour.wait(300);
    tour.start(workbench());
}

bool InspectPage::tourReady() const
{
    return d->tour.done();
}

} // namespace gripscope
