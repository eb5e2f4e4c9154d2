// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validation_records.h"

#include "core/identification/fit.h"
#include "core/identification/identification.h"
#include "core/signal/units.h"
#include "core/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double firstShare = 0.6;
constexpr std::size_t shortest = 100, longest = 100'000;

/// How many of `to` are in one of `from`; nothing where that is not known.
std::optional<double> quotient(const QString& from, const QString& to,
                               std::optional<double> (*base)(const QString&))
{
    if (from == to)
        return 1;
    const std::optional<double> one = base(from);
    const std::optional<double> other = base(to);
    return one && other ? std::optional(*one / *other) : std::nullopt;
}

void scale(std::vector<double>& values, double factor)
{
    if (factor == 1)
        return;
    for (double& value : values)
        value *= factor;
}

bool usable(const PreparedRecord& record)
{
    return record.force.size() == record.position.size() && std::isfinite(record.sampleTime_s) &&
           record.sampleTime_s > 0 && std::isfinite(record.forceLag_s) && allFinite(record.force) &&
           allFinite(record.position);
}

} // namespace

Validation validateOnSecondWindow(Estimator estimator, const PreparedRecord& record,
                                  const EstimatorTask& task)
{
    Validation none;
    none.estimator = estimator;
    const std::size_t count = std::min(record.force.size(), longest);
    if (count < shortest) {
        none.message =
            Words::tr("fewer than %1 samples are too few to estimate on one part and check on the other; "
                      "validate with another squeeze")
                .arg(shortest);
        return none;
    }
    const auto first = static_cast<std::size_t>(firstShare * static_cast<double>(count));
    const Estimate estimate = runEstimator(estimator, windowOf(record, {0, first}), task);
    if (estimate.status != EstimateStatus::Converged) {
        none.message =
            Words::tr("the first 60 % of the record alone do not give m, b and k; validate with another "
                      "squeeze");
        return none;
    }
    PreparedRecord rest = windowOf(record, {first, count - first});
    if (record.time_s.size() >= count)
        rest.time_s.assign(record.time_s.begin() + static_cast<std::ptrdiff_t>(first),
                           record.time_s.begin() + static_cast<std::ptrdiff_t>(count));
    Validation validation = validate(estimate, rest, task.hold);
    validation.estimatedOn = {estimate.part.first, estimate.part.count};
    validation.validatedOn.first += first;
    return validation;
}

Validation validateOnRecording(const Estimate& estimate, const Recording& recording, const Recording& other,
                               const QString& name, const IdentificationOptions& options)
{
    Validation none;
    none.estimator = estimate.estimator;
    none.source = ValidationSource::OtherRecording;
    none.name = name;
    const std::optional<double> force = quotient(other.forceUnit, recording.forceUnit, newtonsPer);
    const std::optional<double> position = quotient(other.positionUnit, recording.positionUnit, metresPer);
    if (!force || !position) {
        none.message =
            Words::tr("the other recording is in %1 and %2, which cannot be compared with %3 and %4")
                .arg(other.forceUnit, other.positionUnit, recording.forceUnit, recording.positionUnit);
        return none;
    }
    PreparationOptions preparation;
    preparation.hold = options.hold;
    PreparedRecord record = prepare(other, preparation);
    if (!usable(record)) {
        none.message =
            Words::tr("the other recording cannot be used: its channels differ in length or hold values "
                      "that are no numbers");
        return none;
    }
    scale(record.force, *force);
    scale(record.position, *position);
    Validation validation =
        validate(estimate, record, options.hold.value_or(other.hold.value_or(ForceHold::First)));
    validation.source = none.source;
    validation.name = name;
    validation.estimatedOn = estimate.part;
    return validation;
}

} // namespace gripscope
