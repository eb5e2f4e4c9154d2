// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/history_words.h"

#include "core/calibration/calibration_facts.h"
#include "ui/format/calibration_words.h"
#include "ui/format/date_text.h"
#include "ui/format/estimate_words.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/format/parameter_text.h"

#include <QLocale>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const auto separator = u" · "_s;

QString orDash(const QString& text)
{
    return text.isEmpty() ? QString(QChar(0x2013)) : text;
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
    return tr("%1, enrolled %2").arg(orDash(entry.type), shortTimeText(entry.time));
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

QString HistoryWords::summary(const HistoryCounts& counts)
{
    QStringList parts;
    const auto add = [&parts](qint64 count, const QString& words) {
        if (count > 0)
            parts << words.arg(formatCount(count));
    };
    add(counts.inspections, tr("%1 inspected"));
    if (counts.judged() > 0)
        parts << tr("%1 as expected")
                     .arg(formatPercent(100.0 * double(counts.asExpected) / double(counts.judged())));
    add(counts.otherType, tr("%1 other type"));
    add(counts.unknown, tr("%1 unknown"));
    add(counts.inconclusive, tr("%1 inconclusive"));
    add(counts.notValid, tr("%1 not valid"));
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
    add(tr("Outcome"), query.outcome ? outcomeWord(*query.outcome) : QString());
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
    add(tr("Time"), exactTimeText(entry.time));
    add(tr("Operator"), orDash(entry.operatorName));
    add(tr("Kind"), entry.accepted ? kind(entry.kind) : tr("enrolment, dropped"));
    add(tr("Expected"), entry.expectedType);
    add(tr("Batch"), entry.batch);
    add(tr("Part"), entry.part);
    if (const auto posterior = entry.tellingPosterior())
        add(tr("Posterior"), formatProbability(std::min(*posterior, 1 - 1e-15)));
    if (entry.distance && entry.gate)
        add(tr("Distance, gate"), u"%1, %2"_s.arg(QLocale().toString(*entry.distance, 'g', 3),
                                                  QLocale().toString(*entry.gate, 'g', 3)));
    if (entry.falseReject && entry.wrongType)
        add(tr("Rates"), tr("false reject %1, wrong type %2")
                             .arg(formatRate(*entry.falseReject), formatRate(*entry.wrongType)));
    if (entry.seconds)
        add(tr("Length"), QLocale().toString(*entry.seconds, 'f', 2) + QChar::Nbsp + u's');
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
    for (const CalibrationFact& fact : calibrationFacts(details.provenance))
        add(tr("Calibration, %1").arg(CalibrationWords::channel(fact.channel)),
            asSentence(fact.words.describe()));
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
