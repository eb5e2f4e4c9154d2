// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/kept_study.h"

#include "core/base/csv.h"
#include "core/base/words.h"
#include "core/library/library.h"
#include "core/quality/plan/plan_json.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Verdicts are somebody's, though the plan names nobody.
bool hasRaters(const PlanDesign& design)
{
    return !design.operators.isEmpty() || design.kind == StudyKind::Attributes;
}

QString personOf(const KeptStudy& study, const StudyMeasurementRecord& record)
{
    const QString planned = study.plan.operatorName(std::size_t(record.measured.row));
    const QString told = planned.isEmpty() ? record.measured.operatorName.trimmed() : planned;
    return told.isEmpty() ? u"-"_s : told;
}

QStringList studyColumns(const PlanDesign& design)
{
    QStringList columns{u"part"_s};
    if (hasRaters(design))
        columns << u"operator"_s;
    columns << u"trial"_s;
    if (!design.stations.isEmpty())
        columns << u"station"_s;
    if (!design.references.isEmpty())
        columns << u"reference"_s;
    columns << u"m"_s << u"b"_s << u"k"_s << u"u_m"_s << u"u_b"_s << u"u_k"_s;
    columns << u"unit_m"_s << u"unit_b"_s << u"unit_k"_s;
    return columns << u"rating"_s << u"validity"_s << u"row"_s << u"utc"_s;
}

QStringList studyCells(const KeptStudy& study, const StudyMeasurementRecord& record)
{
    const PlanDesign& design = study.plan.design;
    const NewStudyMeasurement& measured = record.measured;
    const auto row = std::size_t(measured.row);
    QStringList cells{study.plan.part(row)};
    if (hasRaters(design))
        cells << personOf(study, record);
    cells << QString::number(study.plan.rows[row].trial + 1);
    if (!design.stations.isEmpty())
        cells << study.plan.station(row);
    if (!design.references.isEmpty())
        cells << study.plan.reference(row);
    for (const std::optional<StudyValue>& value : measured.values)
        cells << (value ? exactText(value->value) : QString());
    for (const std::optional<StudyValue>& value : measured.values)
        cells << (value ? exactText(value->standardUncertainty) : QString());
    for (const QString& unit : measured.units)
        cells << unit;
    return cells << measured.rating << measured.validity << QString::number(measured.row + 1)
                 << record.stored.toUTC().toString(Qt::ISODateWithMs);
}

std::vector<QStringList> studyRows(const KeptStudy& study)
{
    std::vector<QStringList> rows;
    for (const StudyMeasurementRecord* const measured : study.counted())
        rows.push_back(studyCells(study, *measured));
    return rows;
}

QByteArray csvLine(const QStringList& cells)
{
    QStringList quoted;
    for (const QString& cell : cells)
        quoted << csvCell(cell);
    return quoted.join(u',').toUtf8() + '\n';
}

} // namespace

StudyProgress KeptStudy::progress() const
{
    std::vector<StudyAttempt> attempts;
    for (const StudyMeasurementRecord& one : measurements)
        attempts.push_back({std::size_t(one.measured.row),
                            attemptOutcomeFromString(one.measured.outcome).value_or(AttemptOutcome::Invalid),
                            one.undone});
    return progressOf(plan, attempts);
}

std::vector<const StudyMeasurementRecord*> KeptStudy::counted() const
{
    const StudyProgress known = progress();
    std::vector<const StudyMeasurementRecord*> found;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        const auto row = std::size_t(measurements[i].measured.row);
        if (row < known.rows.size() && known.rows[row] == RowState::Done && known.counts[row] == i)
            found.push_back(&measurements[i]);
    }
    return found;
}

Expected<KeptStudy> readStudy(Library& library, const QString& studyId)
{
    KeptStudy study;
    ASSIGN_OR_RETURN(std::optional<StudyRecord> record, library.study(studyId));
    if (!record)
        return failure(ErrorCode::NotFound, {Words::say("study with the key %1").arg(studyId)});
    study.record = *std::move(record);
    ASSIGN_OR_RETURN(study.plan, planFromJson(study.record.study.plan));
    study.options = studyOptionsFromJson(study.record.study.options);
    ASSIGN_OR_RETURN(study.measurements, library.studyMeasurements(studyId));
    return study;
}

StudyTable studyTable(const KeptStudy& study)
{
    return StudyTable::of(study.record.study.name, studyColumns(study.plan.design), studyRows(study));
}

QByteArray studyCsv(const KeptStudy& study)
{
    QByteArray text = csvLine(studyColumns(study.plan.design));
    for (const QStringList& row : studyRows(study))
        text += csvLine(row);
    return text;
}

} // namespace gripscope
