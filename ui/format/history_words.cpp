// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/history_words.h"

#include "core/calibration/calibration_facts.h"
#include "ui/format/calibration_words.h"
#include "ui/format/date_text.h"
#include "ui/format/estimate_words.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/format/parameter_text.h"
#include "ui/format/yield_text.h"

#include <QJsonArray>
#include <QLocale>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const auto separator = u" · "_s;

QString orDash(const QString& text)
{
    return text.isEmpty() ? QString(QChar(0x2013)) : text;
}

/// What its row says; else, from before, what its recording says.
std::optional<QString> calibrationOf(const SqueezeDetails& details, SensorChannel channel)
{
    const HistoryEntry& entry = details.entry;
    const std::optional<QString>& stored =
        channel == SensorChannel::Force ? entry.forceCalibration : entry.positionCalibration;
    if (stored)
        return stored;
    const std::optional<CalibrationNote> note = calibrationNote(details.provenance, channel);
    return note ? std::optional(note->words) : std::nullopt;
}

} // namespace

QString HistoryWords::kind(SqueezeKind kind)
{
    return kind == SqueezeKind::Inspection ? tr("inspection") : tr("enrolment");
}

QString HistoryWords::title(const HistoryEntry& entry)
{
    if (entry.number > 0)
        return tr("Inspection %1").arg(entry.number);
    if (!entry.part.isEmpty())
        return tr("%1, part %2").arg(entry.type, entry.part);
    return tr("%1, enrolled %2").arg(orDash(entry.type), timeText(entry.time));
}

QString HistoryWords::outcome(const HistoryEntry& entry)
{
    const std::optional<InspectionOutcome> outcome = entry.outcome();
    if (!outcome)
        return kind(entry.kind);
    const QString word = outcomeWord(*outcome, entry.suspect(), !entry.expectedType.isEmpty());
    return entry.voided.isEmpty() ? word : tr("voided: %1").arg(word);
}

QString HistoryWords::device(const HistoryEntry& entry)
{
    return u"%1 %2"_s.arg(entry.device, entry.serial).trimmed();
}

QString HistoryWords::estimator(const QString& id)
{
    const std::optional<Estimator> known = estimatorFromString(id);
    return known ? estimatorName(*known) : id;
}

QString HistoryWords::how(const Reidentification& again)
{
    const QString hold = !again.hold                      ? tr("hold as recorded")
                         : *again.hold == ForceHold::Zero ? tr("force held between samples")
                                                          : tr("force straight between samples");
    const QString start = again.initialState == InitialState::Free ? tr("free start") : tr("starts at rest");
    return QStringList{hold, start, again.freeOffset ? tr("free offset") : tr("no offset")}.join(separator);
}

QString HistoryWords::validity(ValidityVerdict validity)
{
    switch (validity) {
    case ValidityVerdict::Valid:
        return tr("valid");
    case ValidityVerdict::Suspect:
        return tr("suspect");
    case ValidityVerdict::Invalid:
        return tr("invalid");
    }
    return {};
}

QString HistoryWords::notRecorded()
{
    return tr("not recorded");
}

QString HistoryWords::validity(const SqueezeDetails& details)
{
    // Squeezes of an enrolment, and of before, have it in their document alone.
    const QJsonObject stored = details.document.value(u"validity"_s).toObject();
    const std::optional<ValidityVerdict> known =
        details.entry.validity ? details.entry.validity
                               : validityVerdictFromString(stored.value(u"verdict"_s).toString());
    if (!known)
        return details.entry.verdict ? notRecorded() : QString();
    QStringList failed = details.entry.checksFailed;
    if (failed.isEmpty())
        for (const QJsonValue value : stored.value(u"checks"_s).toArray())
            if (!value[u"ok"_s].toBool(true))
                failed << value[u"id"_s].toString();
    if (*known == ValidityVerdict::Valid || failed.isEmpty())
        return validity(*known);
    for (QString& check : failed)
        check = checkName(check);
    return tr("%1: %2").arg(validity(*known), failed.join(u", "_s));
}

QString HistoryWords::heldTo(const HeldTo& held)
{
    QStringList parts;
    if (held.falseReject && held.wrongType)
        parts << tr("false reject %1, wrong type %2")
                     .arg(formatRate(*held.falseReject), formatRate(*held.wrongType));
    if (!held.strangerAccept) {
        parts << tr("stranger-accept, confidence and robust gates not recorded");
        return parts.join(u", "_s);
    }
    parts << tr("stranger accept %1").arg(formatRate(*held.strangerAccept));
    parts << (held.confidence ? tr("for this library with %1 confidence").arg(formatRate(*held.confidence))
                              : tr("on average over libraries"));
    if (held.robust.value_or(false))
        parts << tr("robust gates");
    return parts.join(u", "_s);
}

QString HistoryWords::calibration(const std::optional<QString>& words)
{
    if (!words)
        return notRecorded();
    return words->isEmpty() ? tr("not calibrated: the gripper's own scale was taken")
                            : heardCalibration(*words).describe();
}

QString HistoryWords::summary(const HistoryCounts& counts)
{
    QStringList parts;
    const auto add = [&parts](qint64 count, const QString& words) {
        if (count > 0)
            parts << words.arg(formatCount(count));
    };
    add(counts.inspections, tr("%1 inspected"));
    if (const QString yield = yieldText(yieldOf(counts)); !yield.isEmpty())
        parts << yield;
    add(counts.otherType, tr("%1 other type"));
    add(counts.doesNotConform, tr("%1 not conforming"));
    add(counts.unknown, tr("%1 unknown"));
    add(counts.inconclusive, tr("%1 inconclusive"));
    add(counts.notValid, tr("%1 not valid"));
    add(counts.suspect, tr("%1 suspect"));
    add(counts.voided, tr("%1 voided"));
    add(counts.enrolled, tr("%1 enrolled"));
    return parts.join(separator);
}

std::vector<Fact> HistoryWords::filter(const HistoryQuery& query)
{
    std::vector<Fact> facts;
    const auto add = [&facts](const QString& name, const QString& text) {
        if (!text.isEmpty())
            facts.push_back({name, text, false});
    };
    add(tr("Text"), query.text);
    add(tr("Kind"), query.kind ? kind(*query.kind) : QString());
    add(tr("Outcome"), query.outcome ? outcomeFilterWord(*query.outcome) : QString());
    add(tr("Validity"), query.validity ? validity(*query.validity) : QString());
    add(tr("Type"), query.type);
    add(tr("Expected"), query.expected);
    add(tr("Operator"), query.operatorName);
    add(tr("Gripper"), query.device);
    add(tr("Batch"), query.batch);
    if (query.from.isValid())
        add(tr("From"), dateText(query.from));
    if (query.to.isValid())
        add(tr("To"), dateText(query.to.addMSecs(-1)));
    return facts;
}

std::vector<Fact> HistoryWords::facts(const SqueezeDetails& details)
{
    const HistoryEntry& entry = details.entry;
    std::vector<Fact> facts;
    const auto add = [&facts](const QString& name, const QString& text) {
        if (!text.isEmpty())
            facts.push_back({name, text, false});
    };
    add(tr("Time"), entry.utcOffset_s ? timeThereText(entry.timeThere()) : exactTimeText(entry.time));
    add(tr("Station"), entry.station);
    if (const auto& step = entry.clockSetBack) {
        const auto shown = [&entry](const QDateTime& time) {
            return entry.utcOffset_s ? timeThereText(time.toOffsetFromUtc(int(*entry.utcOffset_s)))
                                     : exactTimeText(time);
        };
        add(tr("Clock"), tr("The station's clock was set back from %1 to %2: this time may be wrong.")
                             .arg(shown(step->from), shown(step->to)));
    }
    add(tr("Operator"), orDash(entry.operatorName));
    add(tr("Kind"), entry.accepted ? kind(entry.kind) : tr("enrolment, dropped"));
    add(tr("Validity"), validity(details));
    add(tr("Expected"), entry.expectedType);
    add(tr("Batch"), entry.batch);
    add(tr("Part"), entry.part);
    add(tr("Part number"), entry.partNumber);
    add(tr("Voided, does not count"), entry.voided);
    if (entry.conformityValues)
        add(tr("Tolerance limits"), inWords(*entry.conformityValues).describe());
    if (const auto posterior = entry.tellingPosterior())
        add(tr("Posterior"), formatProbability(std::min(*posterior, 1 - 1e-15)));
    if (entry.distance && entry.gate)
        add(tr("Distance, gate"), tr("%1 sd, %2 sd")
                                      .arg(QLocale().toString(std::sqrt(*entry.distance), 'f', 1),
                                           QLocale().toString(std::sqrt(*entry.gate), 'f', 1)));
    if (entry.verdict)
        add(tr("Rates"), heldTo(entry.heldTo));
    if (entry.verdict || entry.libraryVersion)
        add(tr("Types"), entry.libraryVersion ? tr("version %1 of the library").arg(*entry.libraryVersion)
                                              : tr("version of the library not recorded"));
    if (entry.seconds)
        add(tr("Length"), formatLength(*entry.seconds));
    if (details.samples > 0)
        add(tr("Samples"), formatCount(qint64(details.samples)));
    const QString known = device(entry);
    add(tr("Gripper"), known.isEmpty() ? QStringList{details.provenance.value(u"device"_s),
                                                     details.provenance.value(u"serial"_s)}
                                             .join(u' ')
                                             .trimmed()
                                       : known);
    add(tr("Firmware"), details.provenance.value(u"firmware"_s));
    add(tr("Source"), entry.source);
    if (details.samples > 0) // else of an imported table
        for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position})
            add(tr("Calibration, %1").arg(CalibrationWords::channel(channel)),
                asSentence(calibration(calibrationOf(details, channel))));
    add(tr("Software"), entry.program);
    return facts;
}

std::vector<Fact> HistoryWords::parameters(const StoredEstimate& estimate, const QString& forceUnit,
                                           const QString& positionUnit)
{
    if (!estimate.parameters)
        return {};
    const ParameterTexts texts =
        parameterTexts(*estimate.parameters, estimate.standardErrors, forceUnit, positionUnit);
    return {{tr("m"), texts.m.text()}, {tr("b"), texts.b.text()}, {tr("k"), texts.k.text()}};
}

} // namespace gripscope
