// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic/periodic.h"

#include "core/base/words.h"
#include "core/identification/model/lag_alignment.h"
#include "core/identification/periodic/periodic_search.h"
#include "core/math/fit.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t fewestPeriods = 4;
/// Longer records are used from their end: the transform needs some 100 bytes a sample.
constexpr std::size_t mostUsedSamples = 8'000'000;
/// The cost is called too large once in a hundred good squeezes.
constexpr double misfitP = 0.01;
/// Below this smallest eigenvalue of the scaled information the lines do not determine m, b and k.
constexpr double leastEigenvalue = 1e-13;

PeriodicResult failedPeriodic(EstimateStatus status, const Finding& message)
{
    PeriodicResult result;
    result.estimate.estimator = Estimator::Periodic;
    result.estimate.status = status;
    result.estimate.message = message;
    return result;
}

/// The longest run without lost samples.
Window unbroken(std::size_t count, const std::vector<std::size_t>& lost)
{
    Window longest;
    std::size_t begin = 0;
    const auto consider = [&](std::size_t end) {
        if (end > begin && end - begin > longest.count)
            longest = {begin, end - begin};
        begin = end + 1;
    };
    for (const std::size_t index : lost)
        consider(std::min(index, count));
    consider(count);
    return longest;
}

/// Whole periods of force, and the positions that belong to them, over powers of two near their largest
/// values so that no square overflows.
struct Periods {
    std::vector<double> force, position;
    Window window; ///< of the force
    std::size_t count = 0;
    double forceScale = 1, positionScale = 1, positionRange = 0;
};

std::vector<double> scaledPart(const std::vector<double>& values, std::size_t first, std::size_t count,
                               double scale)
{
    std::vector<double> out(count);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = values[first + i] / scale;
    return out;
}

/// The last whole periods of `repeating`, for whose force there are positions: position n belongs to force
/// n + lag.
Periods wholePeriods(const std::vector<double>& force, const std::vector<double>& position, Window repeating,
                     std::size_t period, const LagAlignment& lag)
{
    const auto count = static_cast<std::ptrdiff_t>(force.size());
    auto begin = static_cast<std::ptrdiff_t>(repeating.first);
    auto end = begin + static_cast<std::ptrdiff_t>(std::min(repeating.count, mostUsedSamples));
    begin = std::max(begin, std::clamp<std::ptrdiff_t>(lag.samples, 0, count));
    end = std::min(end, count + std::clamp<std::ptrdiff_t>(lag.samples, -count, 0));
    Periods out;
    if (end <= begin)
        return out;
    out.count = static_cast<std::size_t>(end - begin) / period;
    out.window.count = out.count * period;
    out.window.first = static_cast<std::size_t>(end) - out.window.count;
    if (out.count < fewestPeriods)
        return out;
    out.forceScale = powerOfTwoScale(force);
    out.positionScale = powerOfTwoScale(position);
    out.force = scaledPart(force, out.window.first, out.window.count, out.forceScale);
    const auto first = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(out.window.first) - lag.samples);
    out.position = scaledPart(position, first, out.window.count, out.positionScale);
    const auto range = std::minmax_element(out.position.begin(), out.position.end());
    out.positionRange = *range.second - *range.first;
    return out;
}

MassDampingStiffness toChannelUnits(const Eigen::Vector3d& theta, const Periods& periods, double sampleTime_s)
{
    const double unit = std::log(periods.forceScale) - std::log(periods.positionScale);
    const double time = std::log(sampleTime_s);
    return {std::exp(theta(0) + unit + 2 * time), std::exp(theta(1) + unit + time),
            std::exp(theta(2) + unit)};
}

std::optional<Eigen::Vector3d> toTheta(const std::optional<MassDampingStiffness>& parameters,
                                       const Periods& periods, double sampleTime_s)
{
    if (!parameters || !(parameters->vector().minCoeff() > 0) || !parameters->vector().allFinite())
        return std::nullopt;
    const double unit = std::log(periods.forceScale) - std::log(periods.positionScale);
    const double time = std::log(sampleTime_s);
    return Eigen::Vector3d(std::log(parameters->m) - unit - 2 * time, std::log(parameters->b) - unit - time,
                           std::log(parameters->k) - unit);
}

/// Of theta: H^-1 M H^-1 / 2, H the information with known noise, M what measuring the noise adds; a half,
/// since the cost counts complex numbers of variance 1. Nothing when H is singular.
std::optional<Eigen::Matrix3d> covarianceOfTheta(const PeriodicCost& cost)
{
    const Eigen::Vector3d diagonal = cost.information.diagonal();
    if (!(diagonal.minCoeff() > 0))
        return std::nullopt;
    const Eigen::Vector3d scale = diagonal.cwiseSqrt().cwiseInverse();
    const Eigen::Matrix3d scaled = scale.asDiagonal() * cost.information * scale.asDiagonal();
    // The determinant of a correlation matrix is at most its smallest eigenvalue times 9/4.
    if (!(scaled.determinant() > leastEigenvalue))
        return std::nullopt;
    const Eigen::Matrix3d inverse = scaled.inverse();
    const Eigen::Matrix3d middle = scale.asDiagonal() * cost.scatter * scale.asDiagonal();
    const Eigen::Matrix3d covariance =
        scale.asDiagonal() * (inverse * middle * inverse / 2) * scale.asDiagonal();
    return covariance.allFinite() ? std::optional<Eigen::Matrix3d>(covariance) : std::nullopt;
}

Finding twoDigits(double value)
{
    return Finding::number(value, 'g', 2);
}

Finding convergedMessage(const PeriodicDiagnostics& diagnostics)
{
    Finding message = Words::say("converged on %1 periods of %2 samples")
                          .arg(diagnostics.periods)
                          .arg(diagnostics.periodSamples);
    if (diagnostics.costP < misfitP)
        message +=
            Words::say("; the misfit is larger than the noise between periods explains, and the errors "
                       "were enlarged to match");
    if (diagnostics.distortionP && *diagnostics.distortionP < misfitP)
        message += Words::say("; harmonics that the force does not have show a nonlinear answer of %1 %")
                       .arg(twoDigits(*diagnostics.distortionPercent));
    return message;
}

/// The period and where it holds, or words why there is none.
struct Repetition {
    std::size_t period = 0;
    Window window;
    EstimateStatus status = EstimateStatus::Converged;
    Finding message;
};

Repetition findRepetition(const std::vector<double>& force, const PeriodicOptions& options)
{
    Repetition out;
    const Window run = unbroken(force.size(), options.lost);
    const std::span<const double> values(force.data() + run.first, run.count);
    const std::optional<std::size_t> period = options.period ? options.period : findPeriod(values);
    if (!period || *period < 4) {
        out.status = EstimateStatus::NotApplicable;
        out.message =
            Words::say("the force does not repeat four times or more without lost samples; record a periodic "
                       "excitation, such as inverse-repeat, over at least four periods");
        return out;
    }
    out.period = *period;
    if (values.size() / *period < fewestPeriods) {
        out.status = EstimateStatus::TooFewSamples;
        out.message =
            Words::say("there are %1 periods without lost samples, and four are needed; record more periods")
                .arg(twoDigits(double(values.size()) / double(*period)));
        return out;
    }
    out.window = periodicStretch(values, *period);
    out.window.first += run.first;
    if (out.window.count / *period < fewestPeriods) {
        out.status = EstimateStatus::NotApplicable;
        out.message = Words::say("the force does not repeat after %1 samples over four periods; record a "
                                 "periodic excitation, such as inverse-repeat")
                          .arg(*period);
    }
    return out;
}

void describe(const PeriodicProblem& problem, const PeriodicSearch& search, const Periods& periods,
              const PeriodicOptions& options, PeriodicResult& result)
{
    PeriodicDiagnostics diagnostics =
        periodicDiagnostics(problem, search, periods.forceScale, periods.positionScale, options.sampleTime_s);
    diagnostics.window = periods.window;
    Estimate& estimate = result.estimate;
    if (search.outcome == PeriodicOutcome::Converged) {
        estimate.status = EstimateStatus::Converged;
        estimate.message = convergedMessage(diagnostics);
    } else {
        estimate.status = EstimateStatus::NotConverged;
        estimate.message =
            Words::say("the search did not settle; record more periods or a stronger excitation");
    }
    estimate.residuals.inputIndependenceP = diagnostics.costP;
    if (diagnostics.costP < misfitP && estimate.covariance)
        *estimate.covariance *= diagnostics.costRatio;
    result.diagnostics = std::move(diagnostics);
}

} // namespace

PeriodicResult analysePeriodic(const std::vector<double>& force, const std::vector<double>& position,
                               const PeriodicOptions& options)
{
    const Repetition repetition = findRepetition(force, options);
    if (repetition.status != EstimateStatus::Converged)
        return failedPeriodic(repetition.status, repetition.message);
    const LagAlignment lag(options.lag_s, options.sampleTime_s);
    const Periods periods = wholePeriods(force, position, repetition.window, repetition.period, lag);
    if (periods.count < fewestPeriods)
        return failedPeriodic(EstimateStatus::TooFewSamples,
                              Words::say("the lag between the channels leaves too few periods"));
    if (!(periods.positionRange > 0))
        return failedPeriodic(EstimateStatus::NotIdentifiable,
                              Words::say("the position does not change; check that the fingers hold "
                                         "the object and that the sensor works"));

    const PeriodicProblem problem(periodicSpectrum(periods.force, periods.position, periods.count),
                                  options.hold, lag.rest, periods.positionRange);
    const Finding tooFewLines =
        Words::say("the repeating force has too few frequencies to determine m, b and k; "
                   "squeeze with a richer one");
    if (problem.lines.size() < 2)
        return failedPeriodic(EstimateStatus::NotIdentifiable, tooFewLines);
    const PeriodicSearch search =
        searchPeriodic(problem, toTheta(options.start, periods, options.sampleTime_s), options.maxIterations);
    PeriodicResult result = failedPeriodic(EstimateStatus::NotIdentifiable, tooFewLines);
    result.estimate.iterations = search.iterations;
    if (search.outcome == PeriodicOutcome::Diverged)
        return result;
    const std::optional<Eigen::Matrix3d> covariance = covarianceOfTheta(search.cost);
    if (!covariance)
        return result;
    const MassDampingStiffness parameters = toChannelUnits(search.theta, periods, options.sampleTime_s);
    const Eigen::Vector3d p = parameters.vector();
    const Eigen::Matrix3d inUnits = p.asDiagonal() * *covariance * p.asDiagonal();
    if (!p.allFinite() || !(p.minCoeff() > 0) || !inUnits.allFinite()) {
        result.estimate.message = Words::say("m, b or k is outside the range of numbers");
        return result;
    }
    result.estimate.parameters = parameters;
    result.estimate.covariance = inUnits;
    describe(problem, search, periods, options, result);
    fitPeriodicResponse(force, position, options, result.estimate);
    return result;
}

Estimate estimatePeriodic(const std::vector<double>& force, const std::vector<double>& position,
                          const PeriodicOptions& options)
{
    return analysePeriodic(force, position, options).estimate;
}

std::optional<std::size_t> excitationPeriod(const Recording& recording)
{
    bool ok = false;
    const qulonglong period = recording.provenance.value(u"excitation_period_samples"_s).toULongLong(&ok);
    return ok && period > 0 ? std::optional<std::size_t>(period) : std::nullopt;
}

} // namespace gripscope
