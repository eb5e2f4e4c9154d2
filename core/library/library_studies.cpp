// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/draft_tables.h"
#include "core/library/tables/study_tables.h"
#include "core/people/audit_entry.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<StudyRecord> requireStudy(Database& database, const QString& id)
{
    ASSIGN_OR_RETURN(auto study, study_table::find(database, id));
    if (!study)
        return failure(ErrorCode::NotFound, {Words::tr("study with the key %1").arg(id)});
    return *std::move(study);
}

Expected<StudyRecord> requireOpenStudy(Database& database, const QString& id)
{
    ASSIGN_OR_RETURN(StudyRecord study, requireStudy(database, id));
    if (study.state != StudyState::Open)
        return failure(ErrorCode::Usage,
                       {Words::tr("The study %1 has ended; nothing is added to it or taken back any more.")
                            .arg(study.study.name)});
    return study;
}

std::optional<Error> measurementProblem(const NewStudyMeasurement& measured)
{
    const auto isSound = [](const std::optional<StudyValue>& value) {
        return !value || (std::isfinite(value->value) && std::isfinite(value->standardUncertainty) &&
                          value->standardUncertainty >= 0);
    };
    if (measured.row < 0 || !std::ranges::all_of(measured.values, isSound))
        return Error{ErrorCode::Usage,
                     {Words::tr("A measurement of a study has finite numbers and a row of its plan.")}};
    return std::nullopt;
}

} // namespace

Expected<StudyRecord> Library::beginStudy(const NewStudy& study)
{
    NewStudy asked = study;
    asked.name = study.name.trimmed();
    if (asked.name.isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("A study needs a name.")});
    if (asked.kind.isEmpty() || asked.plan.isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("A study needs its kind and its plan.")});
    return d->write<StudyRecord>(Words::tr("begin the study"), [&]() -> Expected<StudyRecord> {
        const RowStamp stamp = RowStamp::now();
        RETURN_IF_ERROR(study_table::insert(*d->database, stamp, asked));
        RETURN_IF_ERROR(audit_table::append(*d->database, {QString::fromUtf16(audit_action::studyBegun),
                                                           asked.name,
                                                           {},
                                                           {{u"kind"_s, asked.kind}},
                                                           asked.operatorName}));
        return requireStudy(*d->database, stamp.id);
    });
}

Expected<StudyMeasurementRecord> Library::addStudyMeasurement(const NewStudyMeasurement& measured)
{
    if (const auto problem = measurementProblem(measured))
        return tl::unexpected<Error>(*problem);
    using Stored = Expected<StudyMeasurementRecord>;
    return d->write<StudyMeasurementRecord>(Words::tr("store the measurement"), [&]() -> Stored {
        RETURN_IF_ERROR(requireOpenStudy(*d->database, measured.studyId));
        const RowStamp stamp = RowStamp::now();
        if (measured.squeeze)
            RETURN_IF_ERROR(draft_squeeze_table::insert(*d->database, RowStamp::now(), *measured.squeeze));
        RETURN_IF_ERROR(study_measurement_table::insert(*d->database, stamp, measured));
        ASSIGN_OR_RETURN(auto stored, study_measurement_table::find(*d->database, stamp.id));
        return *std::move(stored);
    });
}

Expected<void> Library::undoStudyMeasurement(const QString& measurementId, const QString& reason,
                                             const QString& operatorName)
{
    return d->write<void>(Words::tr("take the measurement back"), [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(const auto measured, study_measurement_table::find(*d->database, measurementId));
        if (!measured)
            return failure(ErrorCode::NotFound,
                           {Words::tr("measurement with the key %1").arg(measurementId)});
        if (measured->undone)
            return {};
        ASSIGN_OR_RETURN(const StudyRecord study, requireOpenStudy(*d->database, measured->measured.studyId));
        RETURN_IF_ERROR(
            study_measurement_table::insertUndo(*d->database, measurementId, reason, operatorName));
        return audit_table::append(*d->database, {QString::fromUtf16(audit_action::studyUndone),
                                                  study.study.name,
                                                  reason,
                                                  {{u"row"_s, measured->measured.row + 1}},
                                                  operatorName});
    });
}

Expected<StudyRecord> Library::endStudy(const QString& studyId, StudyState end, const QString& reason,
                                        const QString& operatorName)
{
    if (end == StudyState::Open)
        return failure(ErrorCode::Usage, {Words::tr("A study ends finished or abandoned.")});
    return d->write<StudyRecord>(Words::tr("end the study"), [&]() -> Expected<StudyRecord> {
        ASSIGN_OR_RETURN(const StudyRecord study, requireStudy(*d->database, studyId));
        if (study.state != StudyState::Open)
            return study;
        RETURN_IF_ERROR(study_table::insertEnd(*d->database, studyId, end, reason, operatorName));
        RETURN_IF_ERROR(audit_table::append(*d->database, {QString::fromUtf16(audit_action::studyEnded),
                                                           study.study.name,
                                                           reason,
                                                           {{u"kind"_s, study.study.kind},
                                                            {u"state"_s, toString(end)},
                                                            {u"squeezes"_s, study.measurements}},
                                                           operatorName}));
        return requireStudy(*d->database, studyId);
    });
}

Expected<std::optional<StudyRecord>> Library::study(const QString& studyId) const
{
    return study_table::find(*d->database, studyId);
}

Expected<std::vector<StudyRecord>> Library::studies(int limit) const
{
    return study_table::newest(*d->database, limit, false);
}

Expected<std::vector<StudyRecord>> Library::unfinishedStudies() const
{
    constexpr int mostUnderWay = 1000;
    return study_table::newest(*d->database, mostUnderWay, true);
}

Expected<std::vector<StudyMeasurementRecord>> Library::studyMeasurements(const QString& studyId) const
{
    return study_measurement_table::ofStudy(*d->database, studyId);
}

} // namespace gripscope
