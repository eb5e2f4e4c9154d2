// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/verdict.h"

namespace gripscope {

/// What an inspection shows: one of five outcomes that never share a word or a colour.
enum class InspectionOutcome { AsExpected, OtherType, Unknown, Inconclusive, NotValid };

/// With nothing expected every named type is AsExpected, which is then told as a "known type".
[[nodiscard]] InspectionOutcome inspectionOutcome(VerdictKind verdict, const QString& type,
                                                  const QString& expectedType);
[[nodiscard]] QString toString(InspectionOutcome outcome); ///< "as_expected", "other_type", ...

} // namespace gripscope
