// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic_search.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// A prediction of less than this in units of one line's noise power is no improvement.
constexpr double negligible = 1e-10;
/// Natural logarithms: no step beyond a factor of 7.
constexpr double longestStep = 2;
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
    return length > longestStep ? Eigen::Vector3d(step * (longestStep / length)) : step;
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
