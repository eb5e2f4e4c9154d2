// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/study_record.h"
#include "core/quality/plan/study_progress.h"
#include "core/quality/table/study_table.h"
#include "core/session/quality/study_options.h"

namespace gripscope {

class Library;

/// A study as the library has it: all that is known of it, at any moment.
struct KeptStudy {
    StudyRecord record;
    StudyPlan plan;
    StudyOptions options;
    std::vector<StudyMeasurementRecord> measurements; ///< in the order in which they were made

    [[nodiscard]] StudyProgress progress() const;
    /// Measured and not taken back, one a row of the plan, in the order in which they were made.
    [[nodiscard]] std::vector<const StudyMeasurementRecord*> counted() const;
};

/// NotFound; BadInput for a plan that this program does not read.
[[nodiscard]] Expected<KeptStudy> readStudy(Library& library, const QString& studyId);

/// What counts as a table: part, operator, trial, station, reference (as far as the plan has them), m, b, k,
/// their standard uncertainties u_m, u_b, u_k and units, rating, validity, row of the plan and time.
/// Numbers are exact; a quantity that was not determined is an empty cell.
[[nodiscard]] StudyTable studyTable(const KeptStudy& study);
/// The same as a file, which `gripscope-cli study gauge FILE --part part --operator operator --value m,b,k
/// --uncertainty u_m,u_b,u_k` reads.
[[nodiscard]] QByteArray studyCsv(const KeptStudy& study);

} // namespace gripscope
