// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/quality/plan/study_progress.h"
#include "core/session/quality/study_session.h"
#include "core/signal/recording/units.h"

#include <cmath>

namespace gripscope {

namespace {

std::array<double, 3> scatteringErrors(const Identification& identification,
                                       const CorrectedParameters& object)
{
    if (const auto alone = repeatedMeasurement(std::span(&identification, 1)))
        return alone->ownErrors;
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = std::sqrt(object.covariance(Eigen::Index(i), Eigen::Index(i)));
    return errors;
}

Findings whyNotUsed(const Identification& identification)
{
    Findings reasons = summaryOf(identification.validity).reasons;
    const Estimate* const recommended = identification.find(identification.recommended);
    if (reasons.empty() && recommended != nullptr && !recommended->message.isEmpty())
        reasons.push_back(recommended->message);
    if (reasons.empty())
        reasons.push_back(Words::say("It does not determine m, b and k."));
    return reasons;
}

bool areFinite(const std::array<double, 3>& numbers)
{
    return std::isfinite(numbers[0]) && std::isfinite(numbers[1]) && std::isfinite(numbers[2]);
}

} // namespace

NewStudyMeasurement squeezeMeasured(const Identification& identification, const Recording& recording)
{
    NewStudyMeasurement measured;
    measured.validity = toString(identification.validity.verdict);
    const auto units = comparableUnits(recording.forceUnit, recording.positionUnit);
    measured.units = {units.m, units.b, units.k};
    const auto object = identification.object();
    const bool isUsable = identification.validity.verdict != ValidityVerdict::Invalid && object;
    const std::array<double, 3> errors =
        object ? scatteringErrors(identification, *object) : std::array<double, 3>{};
    if (!isUsable || !areFinite(errors)) {
        measured.outcome = toString(AttemptOutcome::Invalid);
        measured.reasons = whyNotUsed(identification);
        return measured;
    }
    measured.outcome = toString(AttemptOutcome::Measured);
    if (identification.validity.verdict == ValidityVerdict::Suspect)
        measured.reasons = summaryOf(identification.validity).reasons;
    const double factor = siFactor(recording.forceUnit, recording.positionUnit).value_or(1);
    const Eigen::Vector3d values = factor * object->parameters.vector();
    for (std::size_t i = 0; i < errors.size(); ++i)
        measured.values[i] = StudyValue{values[Eigen::Index(i)], factor * errors[i]};
    return measured;
}

} // namespace gripscope
