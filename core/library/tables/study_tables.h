// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/study_record.h"
#include "core/library/sql/statement.h"

namespace gripscope {

/// "open", "finished", "abandoned".
[[nodiscard]] QString toString(StudyState state);

} // namespace gripscope

namespace gripscope::study_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const NewStudy& study);
[[nodiscard]] Expected<void> insertEnd(Database& database, const QString& studyId, StudyState end,
                                       const QString& reason, const QString& operatorName);
[[nodiscard]] Expected<std::optional<StudyRecord>> find(Database& database, const QString& id);
/// Newest first; those under way alone, where asked for.
[[nodiscard]] Expected<std::vector<StudyRecord>> newest(Database& database, int limit, bool openOnly);

} // namespace gripscope::study_table

namespace gripscope::study_measurement_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp,
                                    const NewStudyMeasurement& measured);
[[nodiscard]] Expected<void> insertUndo(Database& database, const QString& measurementId,
                                        const QString& reason, const QString& operatorName);
[[nodiscard]] Expected<std::optional<StudyMeasurementRecord>> find(Database& database, const QString& id);
/// In the order in which they came.
[[nodiscard]] Expected<std::vector<StudyMeasurementRecord>> ofStudy(Database& database,
                                                                    const QString& studyId);

} // namespace gripscope::study_measurement_table
