// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/plan/study_progress.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gripscope {

namespace {

constexpr std::array<std::pair<AttemptOutcome, const char16_t*>, 3> outcomeNames{
    {{AttemptOutcome::Measured, u"measured"},
     {AttemptOutcome::Invalid, u"invalid"},
     {AttemptOutcome::Skipped, u"skipped"}}};

/// Takes in one try after the other.
void takeAttempt(const StudyAttempt& attempt, std::size_t place, StudyProgress& progress)
{
    RowState& state = progress.rows[attempt.row];
    if (attempt.outcome != AttemptOutcome::Skipped)
        ++progress.squeezes[attempt.row];
    if (attempt.undone || attempt.outcome == AttemptOutcome::Invalid) {
        if (state == RowState::Planned && attempt.outcome != AttemptOutcome::Skipped)
            state = RowState::Repeat;
        return;
    }
    state = attempt.outcome == AttemptOutcome::Measured ? RowState::Done : RowState::Skipped;
    progress.counts[attempt.row] = place;
    progress.undoable = place;
}

} // namespace

QString toString(AttemptOutcome outcome)
{
    for (const auto& [known, name] : outcomeNames)
        if (known == outcome)
            return QString::fromUtf16(name);
    return {};
}

std::optional<AttemptOutcome> attemptOutcomeFromString(const QString& text)
{
    for (const auto& [known, name] : outcomeNames)
        if (QString::fromUtf16(name) == text)
            return known;
    return std::nullopt;
}

StudyProgress progressOf(const StudyPlan& plan, const std::vector<StudyAttempt>& attempts)
{
    StudyProgress progress;
    progress.rows.assign(plan.rows.size(), RowState::Planned);
    progress.squeezes.assign(plan.rows.size(), 0);
    progress.counts.assign(plan.rows.size(), std::nullopt);
    for (std::size_t i = 0; i < attempts.size(); ++i)
        if (attempts[i].row < plan.rows.size())
            takeAttempt(attempts[i], i, progress);
    for (std::size_t row = 0; row < plan.rows.size(); ++row) {
        const RowState state = progress.rows[row];
        progress.done += state == RowState::Done ? 1 : 0;
        progress.skipped += state == RowState::Skipped ? 1 : 0;
        progress.repeated += progress.squeezes[row] > 1 ? 1 : 0;
        if (!progress.next && (state == RowState::Planned || state == RowState::Repeat))
            progress.next = row;
    }
    return progress;
}

} // namespace gripscope
