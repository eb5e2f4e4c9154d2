// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/people/acting.h"
#include "core/recognition/types/squeeze_table.h"

#include <QString>

namespace gripscope::cli {

/// At the end of an enrolment from files: in a library without people the type is approved, by whoever
/// enrolled it; where people are, it waits for one who may. Whether its parts are recognised now, which is
/// told on standard error.
[[nodiscard]] Expected<bool> approveEnrolled(Library& library, const QString& type,
                                             const QString& operatorName);

/// A table of m, b and k that is to become squeezes of types.
struct TableEnrollment {
    QString table; ///< file
    SqueezeColumns columns;
    QString forceUnit = QStringLiteral("1"), positionUnit = QStringLiteral("1");
    Acting acting = {}; ///< who adds them
};

/// Adds every row that is a squeeze; a row that is refused, by itself or by the library (units that cannot be
/// compared with those of its types, a row that is there already), does not stop the others. Tells what
/// became of them; the exit code.
int enrollTable(const TableEnrollment& task, const QString& libraryFile, bool json);

} // namespace gripscope::cli
