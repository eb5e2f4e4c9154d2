// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect/inspect_parts.h"

#include "core/base/words.h"
#include "core/session/connection/stop_words.h"
#include "core/signal/recording/units.h"
#include "ui/charts/type_map.h"
#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/format/determined_text.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/format/parameter_text.h"
#include "ui/pages/tour_script.h"
#include "ui/settings/values/settings.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/windows/stop_controls.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

struct Hint {
    Q_DECLARE_TR_FUNCTIONS(InspectHint)
};

/// Whether it was not even armed; what stops an armed one has other codes (GripperPort::disarmReason).
bool neverArmed(const Error& reason)
{
    return reason.code == ErrorCode::ArmingRefused || reason.code == ErrorCode::DeviceTimeout ||
           reason.code == ErrorCode::DeviceRefused;
}

} // namespace

InspectHint inspectHint(Workbench& workbench, const QString& time)
{
    ConnectSession& connection = workbench.connection();
    const InspectSession& session = workbench.inspection();
    switch (session.state()) {
    case InspectSession::State::Squeezing:
        return {Hint::tr("Squeezing…"), Hint::tr("Esc or STOP ends it at once")};
    case InspectSession::State::Judging:
        return {Hint::tr("Judging…"), {}};
    case InspectSession::State::Loading:
        return {Hint::tr("Reading the library…"), {}};
    case InspectSession::State::Ready:
        break;
    }
    if (connection.state() != ConnectSession::State::Connected)
        return {missingWords(connection).headline, missingWords(connection).detail};
    if (session.types().empty())
        return {Hint::tr("No types yet"), Hint::tr("Enroll at least one type (Ctrl+3), then inspect parts")};
    if (session.approvedTypes().empty())
        return {Hint::tr("No approved type"),
                Hint::tr("A type is recognised once it is approved: finish its enrolment (Ctrl+3), or ask a "
                         "supervisor to approve it")};
    if (StopStanding::of(workbench).stopped())
        return {Hint::tr("Stopped"),
                Hint::tr("The gripper is not armed. Place the part, hands clear, then arm it")};
    // It stands here too, for whoever has put the message away.
    if (const std::optional<Error>& reason = StopStanding::of(workbench).disarmReason();
        reason && !connection.armed())
        return {neverArmed(*reason) ? Hint::tr("Not armed") : Hint::tr("Disarmed"), reason->describe()};
    if (!connection.armed() && connection.identity().commandable)
        return {Hint::tr("Not armed"), Hint::tr("Place the part, hands clear, then arm the gripper")};
    return {Hint::tr("Ready"), Hint::tr("Place the part, then squeeze: %1").arg(time)};
}

InspectHint pastHint(Workbench& workbench, const QString& time, const InspectSession::Result& last)
{
    const StopStanding& standing = StopStanding::of(workbench);
    const VerdictWords words = verdictWords(last);
    InspectHint hint = inspectHint(workbench, time);
    if (workbench.inspection().state() != InspectSession::State::Ready)
        return hint;
    if (standing.notObeyed())
        return {Hint::tr("Not stopped"), notObeyedWords()};
    if (standing.stopped())
        hint.headline = Hint::tr("Stopped");
    hint.words = Hint::tr("The last part: %1, %2").arg(words.headline, words.outcome);
    return hint;
}

InspectHint unknownCodeHint(const QString& code, const QString& expected)
{
    return {Hint::tr("No type is called or coded “%1”").arg(code),
            expected.isEmpty() ? Hint::tr("Nothing is expected, as before")
                               : Hint::tr("%1 is expected, as before").arg(expected)};
}

InspectHint expectedHint(const QString& expected)
{
    return {expected.isEmpty() ? Hint::tr("Nothing expected") : expected,
            expected.isEmpty() ? Hint::tr("The next part may be any enrolled type")
                               : Hint::tr("is expected from the next part on")};
}

InspectHint buttonHint()
{
    return {Hint::tr("Not ready to squeeze"),
            Hint::tr("The gripper's button squeezes once a gripper is connected and armed here")};
}

InspectMeasurement::InspectMeasurement(QWidget* parent) : QFrame(parent)
{
    setRole(this, "card");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 8, 4);
    row->setSpacing(16);
    auto* numbers = new QVBoxLayout;
    numbers->setSpacing(0);
    numbers->addStretch(1);
    const auto add = [&](const QString& name) {
        numbers->addWidget(makeLabel(name, "caption", this));
        QLabel* value = makeLabel(u"–"_s, "number", this);
        value->setAccessibleName(name);
        value->setMinimumWidth(216);
        numbers->addWidget(value);
        numbers->addStretch(1);
        return value;
    };
    m_k = add(tr("stiffness k (95 %)"));
    m_b = add(tr("damping b (95 %)"));
    m_m = add(tr("moving mass m (95 %)"));
    m_further = makeLabel({}, "caption", this);
    m_further->setObjectName("furtherLabel");
    m_further->setWordWrap(true);
    numbers->addWidget(m_further);
    m_map = new TypeMap(this);
    m_note = makeLabel(tr("This says nothing about the part: it is neither good nor bad. The squeeze is kept "
                          "under its number, but counts neither in the yield nor towards the batch."),
                       "", this);
    m_note->setObjectName("notJudgedNote");
    m_note->setWordWrap(true);
    m_note->hide();
    row->addLayout(numbers);
    row->addWidget(m_map, 1);
    row->addWidget(m_note, 1);
}

void InspectMeasurement::setTypes(const TypeModels& models, bool elsewhere)
{
    m_map->setTypes(models, elsewhere);
}

void InspectMeasurement::showResult(const std::optional<InspectSession::Result>& result)
{
    const bool invalid = result && result->outcome == InspectionOutcome::NotValid;
    m_map->setVisible(!invalid);
    m_note->setVisible(invalid);
    const std::optional<CorrectedParameters> object = result ? result->identification.object() : std::nullopt;
    for (QLabel* label : {m_m, m_b, m_k})
        label->setText(u"–"_s);
    std::vector<DeterminedParameter> all;
    if (result)
        all = determinedParameters(result->identification, result->recording.forceUnit,
                                   result->recording.positionUnit);
    m_further->setText(furtherText(all));
    m_further->setVisible(!m_further->text().isEmpty());
    if (object)
        return showObject(*result, *object);
    // A record without m, b and k may still tell one of them.
    const std::array labels{m_m, m_b, m_k};
    for (const DeterminedParameter& one : all)
        if (const auto place = linearPlaceOf(one.parameter)) {
            labels[*place]->setEnabled(false);
            labels[*place]->setText(determinedText(one));
        }
    m_map->setPart(std::nullopt, std::nullopt);
}

void InspectMeasurement::showObject(const InspectSession::Result& result, const CorrectedParameters& object)
{
    const Recording& recording = result.recording;
    const ParameterTexts texts =
        parameterTexts(result.identification, recording.forceUnit, recording.positionUnit);
    const bool valid = result.outcome != InspectionOutcome::NotValid;
    // Numbers of a measurement that is not valid are not the part's: they step back.
    for (QLabel* label : {m_m, m_b, m_k})
        label->setEnabled(valid);
    m_m->setText(texts.m.text());
    m_b->setText(texts.b.text());
    m_k->setText(texts.k.text());
    const std::optional<double> si = siFactor(recording.forceUnit, recording.positionUnit);
    std::optional<MassDampingStiffness> part;
    std::optional<Eigen::Matrix3d> covariance;
    if (si && valid)
        part = MassDampingStiffness{object.parameters.m * *si, object.parameters.b * *si,
                                    object.parameters.k * *si};
    if (si && !object.covariance.isZero(0))
        covariance = *si * object.covariance * *si;
    m_map->setPart(part, covariance);
}

InspectReason::InspectReason(QWidget* parent)
    : QWidget(parent), m_facts(new ElidedLabel({}, this)), m_rates(makeLabel({}, "caption", this)),
      m_reason(makeLabel({}, "", this))
{
    setRole(m_facts, "strong");
    m_facts->setObjectName("factsLabel");
    m_rates->setObjectName("ratesLabel");
    m_rates->setWordWrap(true); // what a verdict is held to is never half of it
    m_reason->setObjectName("reasonLabel");
    m_reason->setWordWrap(true);
    m_reason->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_facts->hide();
    m_reason->hide();
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 2);
    column->addWidget(m_facts);
    column->addWidget(m_reason);
    column->addWidget(m_rates);
}

namespace {

QStringList factsOf(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    QStringList facts;
    const QString of = verdict.type.isEmpty() ? verdict.nearest : verdict.type;
    if (result.outcome != InspectionOutcome::NotValid && !of.isEmpty()) {
        if (verdict.posterior.contains(of) && result.outcome != InspectionOutcome::Unknown)
            facts << InspectReason::tr("posterior of %1: %2")
                         .arg(of, formatProbability(verdict.posterior.value(of)));
        if (verdict.distance && verdict.gate)
            facts << InspectReason::tr("%1 sd from %2 (gate %3 sd)")
                         .arg(Words::number(std::sqrt(*verdict.distance), 'f', 1), of,
                              Words::number(std::sqrt(*verdict.gate), 'f', 1));
    }
    facts << (result.earlyEnd ? InspectReason::tr("length %1, ended when it was decided")
                              : InspectReason::tr("length %1"))
                 .arg(formatLength(result.seconds));
    return facts;
}

} // namespace

void InspectReason::showResult(const InspectSession::Result* result)
{
    if (!result) {
        // Their room stays from the first verdict on, so that nothing jumps while the next squeeze runs.
        m_facts->setFullText(u" "_s);
        m_reason->clear();
        return;
    }
    // What to do about a bad measurement may take two lines and has no facts beside it.
    m_facts->setVisible(result->outcome != InspectionOutcome::NotValid);
    m_reason->show();
    const QStringList facts = factsOf(*result);
    m_facts->setParts(facts.isEmpty() ? QStringList{u" "_s} : facts, u"  ·  "_s);
    m_reason->setText(verdictWords(*result).reason);
    m_reason->setToolTip(described(result->verdict.allReasons()).join(u' '));
}

void InspectReason::showRates(const VerdictOptions& rates)
{
    m_rates->setText(tr("Held to: false-reject %1 (%2), wrong-type %3, stranger-accept %4")
                         .arg(formatRate(rates.falseReject),
                              rates.confidence ? tr("with %1 confidence").arg(formatRate(*rates.confidence))
                                               : tr("on average"),
                              formatRate(rates.wrongType), formatRate(rates.strangerAccept)));
}

SoundButton::SoundButton(Settings& settings, QWidget* parent) : QPushButton(parent), m_settings(&settings)
{
    setRole(this, "quiet");
    setCheckable(true);
    setIconSize({22, 22});
    setFixedWidth(64);
    setFocusPolicy(Qt::TabFocus); // a click must not take Space from the squeeze
    connect(this, &QPushButton::clicked, this,
            [this](bool on) { m_settings->set(setting::soundOnVerdict, on); });
    connect(m_settings, &Settings::changed, this, &SoundButton::refresh);
    connect(&Theme::instance(), &Theme::changed, this, &SoundButton::refresh);
    refresh();
}

void SoundButton::refresh()
{
    const bool on = m_settings->get(setting::soundOnVerdict);
    setChecked(on);
    setIcon(Theme::instance().icon(on ? u"audio-volume-high"_s : u"audio-volume-muted"_s));
    setAccessibleName(on ? tr("Sound on") : tr("Sound off"));
    setToolTip(on ? tr("Each verdict is heard. Click to switch the sound off.")
                  : tr("Verdicts are silent. Click to switch the sound on."));
}

void addInspections(TourScript& tour, Workbench& workbench, const std::function<void()>& expect,
                    const std::function<void()>& squeeze)
{
    const auto inspect = [&tour, &workbench, squeeze](int times) {
        for (int i = 0; i < times; ++i)
            tour.add(squeeze, [&workbench, squeeze] {
                const InspectSession& session = workbench.inspection();
                if (session.state() != InspectSession::State::Ready)
                    return false;
                // A busy machine may have starved the gripper's heartbeat: as a person would, once more.
                if (!session.result() && !workbench.connection().armed())
                    workbench.arm();
                else if (!session.result())
                    squeeze();
                return session.result() && session.result()->number != 0;
            });
    };
    tour.add(expect, [&workbench] { return workbench.inspection().state() == InspectSession::State::Ready; });
    tour.connectTo(workbench, u"virtual:?object=A&seed=21&speed=0"_s);
    inspect(3);
    tour.connectTo(workbench, u"virtual:?object=B&seed=22&speed=0"_s);
    inspect(1);
    // A can that nobody enrolled: between the others in stiffness, with a damping of its own.
    tour.connectTo(workbench, u"virtual:?object=0.05,80,7000&seed=23&speed=0"_s);
    inspect(1);
    tour.connectTo(workbench, u"virtual:?object=A&seed=24&speed=0"_s);
    inspect(1);
    tour.wait(300);
}

} // namespace gripscope
