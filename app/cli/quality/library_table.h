// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/quality/table/study_table.h"

namespace gripscope::cli {

struct LibraryTable {
    StudyTable table;
    QStringList notes; ///< sentences for a person: what was left out, and what stands for what is not there
};

/// part, operator, station, m, b, k, u_m, u_b, u_k, type, expected, verdict, validity, time, gripper, number.
[[nodiscard]] QStringList libraryTableColumns();

/// The squeezes of a library as a table, oldest first, a squeeze a row: of the batch with that name, or,
/// where that is empty, all of them, enrolled ones too. m, b and k and their standard uncertainties are in SI
/// where the channels' units are known, else as they were measured.
///
/// `part` is the number that was scanned; else the type with the part's own name within it; else the type
/// alone (expected, or else named), which a note tells: parts of a type are then taken for one. A cell of
/// what the library does not know is empty, which the table refuses where that column is asked for.
///
/// Left out, and told in a note: squeezes without m, b and k, of measurements that are not valid, voided
/// ones, and enrolled ones that were dropped.
///
/// Errors: NotFound for a batch that is not there, or where no squeeze is left; UnitsDiffer where m, b and k
/// cannot be compared; those of the library.
[[nodiscard]] Expected<LibraryTable> libraryTable(Library& library, const QString& batch);

} // namespace gripscope::cli
