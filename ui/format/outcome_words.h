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
/// The same where it matters whether a type was expected: else a known one is just that, "known type".
[[nodiscard]] QString outcomeWord(InspectionOutcome outcome, bool suspect, bool expected);

/// In a filter, which finds both: "as expected or known type".
[[nodiscard]] QString outcomeFilterWord(InspectionOutcome outcome);

/// What the screen says of a result: the line read from 3 m, and the one below it.
struct VerdictWords {
    QString headline; ///< "Cola 330 ml", "Unknown", "A or B?", "Squeeze again"
    QString outcome;  ///< "as expected", "other type, expected A", ...
    QString reason;   ///< one sentence why; what to do where the measurement is not valid
};
/// `callAfter`: from so many squeezes in a row on that were not valid, another one does not help, and a
/// supervisor is to be called; 0: never.
[[nodiscard]] VerdictWords verdictWords(const InspectSession::Result& result, int callAfter = 0);
[[nodiscard]] bool callsSupervisor(const InspectSession::Result& result, int callAfter);

} // namespace gripscope
