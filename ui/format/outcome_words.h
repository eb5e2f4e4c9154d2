// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect/inspect_session.h"

#include <QString>

namespace gripscope {

/// The words of an outcome, as short as a technician says them: "as expected", "other type", "unknown",
/// "inconclusive", "not valid".
[[nodiscard]] QString outcomeWord(InspectionOutcome outcome);

/// Its measurement is in doubt: a verdict, but none to rely on.
[[nodiscard]] bool isSuspect(const InspectSession::Result& result);
/// "suspect: as expected" where the measurement is in doubt.
[[nodiscard]] QString outcomeWord(InspectionOutcome outcome, bool suspect);

/// What the screen says of a result: the line read from 3 m, and the one below it.
struct VerdictWords {
    QString headline; ///< "Cola 330 ml", "Unknown", "A or B?", "Squeeze again"
    QString outcome;  ///< "as expected", "other type, expected A", ...
    QString reason;   ///< one sentence why; what to do where the measurement is not valid
};
[[nodiscard]] VerdictWords verdictWords(const InspectSession::Result& result);

} // namespace gripscope
