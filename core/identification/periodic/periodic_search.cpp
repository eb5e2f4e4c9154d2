// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic/periodic_search.h"

#include "core/identification/periodic/periodic_response.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace gripscope {

namespace {

using Complex = std::complex<double>;

/// Force, position and position's standard deviation of one harmonic.
struct MeasuredLine {
    double radiansPerSample = 0;
    Complex force, position;
    double variance = 0;
};

std::vector<MeasuredLine> measuredLines(const PeriodicProblem& problem)
{
    std::vector<MeasuredLine> lines;
    for (const LocalFit& fit : problem.lines) {
        const std::vector<Complex>& position = problem.spectrum.position;
        const double power = fit.residual(fit.gather(position)).squaredNorm();
        lines.push_back({problem.spectrum.radiansPerSample(fit.bin), fit.atHarmonic(problem.spectrum.force),
                         fit.atHarmonic(position),
                         fit.varianceFactor * power / fit.degreesOfFreedom + problem.noiseFloor});
    }
    return lines;
}

/// What hold and lag do to the continuous 1 / (K - M w^2 + j w B), folding left out.
Complex holdAndLag(double w, ForceHold hold, double rest)
{
    const double half = std::sin(w / 2) / (w / 2);
    const Complex held = hold == ForceHold::Zero ? half * std::polar(1.0, -w / 2) : Complex(half * half);
    return held * std::polar(1.0, w * rest);
}

/// Weighted with |G|^2 |U| / deviation, which makes the errors of 1/G those of the position.
std::optional<Eigen::Vector3d> linearStart(const std::vector<MeasuredLine>& lines,
                                           const PeriodicProblem& problem)
{
    // Sums of the two normal equations: real part K - M w^2, imaginary part w B.
    double s0 = 0, s2 = 0, s4 = 0, r0 = 0, r2 = 0, imaginary = 0;
    for (const MeasuredLine& line : lines) {
        const double w = line.radiansPerSample;
        if (!(std::norm(line.position) > 0))
            continue;
        const Complex inverse = line.force / line.position * holdAndLag(w, problem.hold, problem.rest);
        const double share = std::norm(line.position) / std::sqrt(std::norm(line.force) * line.variance);
        const double weight = share * share;
        s0 += weight;
        s2 += weight * w * w;
        s4 += weight * w * w * w * w;
        r0 += weight * inverse.real();
        r2 += weight * w * w * inverse.real();
        imaginary += weight * w * inverse.imag();
    }
    const double determinant = s0 * s4 - s2 * s2;
    const Eigen::Vector3d found{(s2 * r0 - s0 * r2) / determinant, imaginary / s2,
                                (s4 * r0 - s2 * r2) / determinant};
    if (!found.allFinite() || !(found.minCoeff() > 0))
        return std::nullopt;
    return Eigen::Vector3d(found.array().log());
}

/// Cost and best compliance for a shape, the position's noise alone counted.
struct Ranked {
    double cost = 0;
    Eigen::Vector3d theta;
};

std::optional<Ranked> ranked(const Eigen::Vector3d& theta, const std::vector<MeasuredLine>& lines,
                             const PeriodicProblem& problem, bool refitCompliance)
{
    const PeriodicResponse response(theta, problem.hold, problem.rest);
    if (!response.finite())
        return std::nullopt;
    double modelPower = 0, product = 0, power = 0;
    for (const MeasuredLine& line : lines) {
        const Complex model = response.at(line.radiansPerSample, line.force).position;
        modelPower += std::norm(model) / line.variance;
        product += (std::conj(model) * line.position).real() / line.variance;
        power += std::norm(line.position) / line.variance;
    }
    const double gain = refitCompliance ? product / modelPower : 1;
    const double cost = power - 2 * gain * product + gain * gain * modelPower;
    if (!(gain > 0) || !std::isfinite(cost) || !std::isfinite(gain))
        return std::nullopt;
    return Ranked{cost, theta - Eigen::Vector3d::Constant(std::log(gain))};
}

/// A prediction of less than this in units of one line's noise power is no improvement.
constexpr double negligible = 1e-10;
/// Natural logarithms: no step beyond a factor of 7.
constexpr double longestLogStep = 2;
constexpr int startsTried = 3;
constexpr int rounds = 6;
constexpr double hopeless = 1e8; ///< damping at which a step is nothing

/// The damped step, columns scaled to the same curvature.
Eigen::Vector3d dampedStep(const PeriodicCost& cost, double damping)
{
    const Eigen::Vector3d scale = cost.curvature.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Eigen::Matrix3d scaled = scale.asDiagonal() * cost.curvature * scale.asDiagonal();
    scaled.diagonal().array() += damping;
    const Eigen::Vector3d step =
        -(scale.asDiagonal() * scaled.ldlt().solve(Eigen::Vector3d(scale.cwiseProduct(cost.gradient))));
    const double length = step.cwiseAbs().maxCoeff();
    return length > longestLogStep ? Eigen::Vector3d(step * (longestLogStep / length)) : step;
}

/// Levenberg-Marquardt for a given start of the motion, and for given variances if any.
void descend(const PeriodicProblem& problem, int maxIterations, const std::vector<double>* variances,
             PeriodicSearch& search)
{
    double damping = 1e-3;
    search.cost = periodicCost(problem, search.theta, search.start, variances);
    search.outcome = search.cost.finite ? PeriodicOutcome::NotConverged : PeriodicOutcome::Diverged;
    if (!search.cost.finite)
        return;
    while (search.iterations < maxIterations) {
        ++search.iterations;
        const Eigen::Vector3d step = dampedStep(search.cost, damping);
        if (!step.allFinite())
            return;
        const double predicted =
            -(2 * search.cost.gradient.dot(step) + step.dot(search.cost.curvature * step));
        if (predicted < negligible * (1 + search.cost.value)) {
            search.outcome = PeriodicOutcome::Converged;
            return;
        }
        PeriodicCost next = periodicCost(problem, search.theta + step, search.start, variances);
        if (next.finite && next.value < search.cost.value) {
            search.theta += step;
            search.cost = std::move(next);
            damping = std::max(damping / 10, 1e-12);
            continue;
        }
        damping *= 8;
        if (damping > hopeless) {
            // No step helps although one is predicted to: rounding, when the prediction is small.
            if (predicted < 1e-4 * (1 + search.cost.value))
                search.outcome = PeriodicOutcome::Converged;
            return;
        }
    }
}

/// Largest change of ln m, ln b, ln k in one round of constant variances, or whole, with the start refitted.
double round(const PeriodicProblem& problem, int maxIterations, bool constantVariances,
             PeriodicSearch& search)
{
    const Eigen::Vector3d before = search.theta;
    search.start = fitStart(problem, search.theta, search.start);
    std::vector<double> variances;
    if (constantVariances)
        variances = periodicCost(problem, search.theta, search.start).variances;
    descend(problem, maxIterations, constantVariances ? &variances : nullptr, search);
    return (search.theta - before).cwiseAbs().maxCoeff();
}

PeriodicSearch searchFrom(const PeriodicProblem& problem, const Eigen::Vector3d& theta, int maxIterations)
{
    PeriodicSearch search;
    search.theta = theta;
    constexpr double close = 0.01;
    constexpr double settled = 1e-9;
    for (int i = 0; i < rounds; ++i) {
        const double change = round(problem, maxIterations, true, search);
        if (search.outcome == PeriodicOutcome::Diverged)
            return search;
        if (change < close)
            break;
    }
    for (int i = 0; i < rounds; ++i) {
        if (round(problem, maxIterations, false, search) < settled ||
            search.outcome != PeriodicOutcome::Converged)
            break;
    }
    return search;
}

} // namespace

std::vector<Eigen::Vector3d> periodicStarts(const PeriodicProblem& problem,
                                            const std::optional<Eigen::Vector3d>& given)
{
    const std::vector<MeasuredLine> lines = measuredLines(problem);
    if (lines.empty())
        return {};
    std::vector<Ranked> candidates;
    const auto consider = [&](const Eigen::Vector3d& theta, bool refitCompliance) {
        if (const std::optional<Ranked> candidate = ranked(theta, lines, problem, refitCompliance))
            candidates.push_back(*candidate);
    };
    if (const std::optional<Eigen::Vector3d> linear = linearStart(lines, problem))
        consider(*linear, true);
    if (given)
        consider(*given, true);
    constexpr int frequencies = 10;
    const double lowest = lines.front().radiansPerSample / 2;
    const double highest = std::min(2 * lines.back().radiansPerSample, 2 * std::numbers::pi);
    for (int i = 0; i < frequencies; ++i) {
        const double w = lowest * std::pow(highest / lowest, static_cast<double>(i) / (frequencies - 1));
        for (const double damping : {0.05, 0.3, 1.0, 3.0})
            consider({0, std::log(2 * damping * w), 2 * std::log(w)}, true);
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Ranked& a, const Ranked& b) { return a.cost < b.cost; });
    std::vector<Eigen::Vector3d> starts;
    for (const Ranked& candidate : candidates)
        starts.push_back(candidate.theta);
    return starts;
}

PeriodicSearch searchPeriodic(const PeriodicProblem& problem, const std::optional<Eigen::Vector3d>& given,
                              int maxIterations)
{
    PeriodicSearch best;
    int tried = 0;
    // Five standard deviations above the expectation.
    const auto lines = static_cast<double>(problem.lines.size());
    const double good = lines + 5 * std::sqrt(2 * lines);
    for (const Eigen::Vector3d& start : periodicStarts(problem, given)) {
        const PeriodicSearch search = searchFrom(problem, start, maxIterations);
        if (search.outcome != PeriodicOutcome::Diverged &&
            (best.outcome == PeriodicOutcome::Diverged || search.cost.value < best.cost.value))
            best = search;
        ++tried;
        if (tried == startsTried || (best.outcome == PeriodicOutcome::Converged && best.cost.value < good))
            break;
    }
    return best;
}

} // namespace gripscope
