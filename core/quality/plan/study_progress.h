// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/plan/study_plan.h"

namespace gripscope {

/// What came of one try at a row of the plan.
enum class AttemptOutcome {
    Measured,
    Invalid, ///< squeezed, but nothing that may be used: the row is to be repeated
    Skipped  ///< a person left it out
};
/// "measured", "invalid", "skipped": as they are stored.
[[nodiscard]] QString toString(AttemptOutcome outcome);
[[nodiscard]] std::optional<AttemptOutcome> attemptOutcomeFromString(const QString& text);

/// One try, as it was stored; a study is the list of all of them.
struct StudyAttempt {
    std::size_t row = 0;
    AttemptOutcome outcome = AttemptOutcome::Measured;
    bool undone = false; ///< taken back later; it stays on record
};

enum class RowState {
    Planned,
    Repeat, ///< squeezed before, in vain or undone, and to be squeezed again
    Done,
    Skipped
};

/// How far a study is: a function of its plan and the tries alone, so that it is the same after a crash.
struct StudyProgress {
    std::vector<RowState> rows;
    std::vector<int> squeezes;                      ///< of each row, in vain or not
    std::vector<std::optional<std::size_t>> counts; ///< of each row: the try that counts
    std::size_t done = 0, skipped = 0, repeated = 0;
    std::optional<std::size_t> next;     ///< the row to be squeezed; none: all is done or skipped
    std::optional<std::size_t> undoable; ///< the newest try that can be taken back

    [[nodiscard]] std::size_t left() const { return rows.size() - done - skipped; }
    [[nodiscard]] bool complete() const { return !next.has_value(); }
};

/// `attempts` in the order in which they were made; of rows that the plan does not have they say nothing. The
/// next row is the first of the plan that is neither done nor skipped: what was undone comes again at once. A
/// squeeze in vain cannot be undone, as nothing counts by it.
[[nodiscard]] StudyProgress progressOf(const StudyPlan& plan, const std::vector<StudyAttempt>& attempts);

} // namespace gripscope
