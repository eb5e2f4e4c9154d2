// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/arx/arx.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/filter_regression.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/identification/output_error/output_error_search.h"
#include "core/math/decompositions.h"
#include "core/math/sequential_qr.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// Share of a column that is rounding.
constexpr double startRounding = 1e-15;
/// Samples the grid is tried on: enough to rank its coarse points.
constexpr std::size_t gridSamples = 2000;

/// Least-squares solution of the triangle whose last column is the right-hand side.
Eigen::VectorXd solveTriangle(const Eigen::MatrixXd& triangle)
{
    const Eigen::Index n = triangle.cols() - 1;
    if (!triangle.allFinite())
        return Eigen::VectorXd::Zero(n);
    return eliminateColumns(triangle, n, startRounding).solution.col(0);
}

/// ln(M, B, K), an impossible sign of M or B replaced by something small: the search will see to it.
std::optional<Eigen::Vector3d> repaired(double m, double b, double k)
{
    if (!std::isfinite(m) || !std::isfinite(b) || !(k > 0) || !std::isfinite(k))
        return std::nullopt;
    if (!(m > 0))
        m = b > 0 ? 0.1 * b * b / k : k;
    if (!(b > 0))
        b = 0.1 * std::sqrt(m * k);
    const Eigen::Vector3d theta(std::log(m), std::log(b), std::log(k));
    return theta.allFinite() ? std::optional(theta) : std::nullopt;
}

std::optional<Eigen::Vector3d> fromStateVariableFilter(const OutputErrorProblem& problem, double bandwidth)
{
    const std::optional<FilterRegression> found = filterRegression(problem, bandwidth, false);
    return found ? repaired(found->mass, found->damping, found->spring[1]) : std::nullopt;
}

std::optional<Eigen::Vector3d> fromArx(const OutputErrorProblem& problem)
{
    const AlignedSamples samples(problem);
    SequentialQr qr(problem.freeOffset ? 7 : 6);
    for (std::ptrdiff_t t = 2; t < samples.count; ++t) {
        auto row = qr.nextRow();
        row.head<5>() << -samples.position(t - 1), -samples.position(t - 2), samples.force(t),
            samples.force(t - 1), samples.force(t - 2);
        if (problem.freeOffset)
            row(5) = 1;
        row(row.size() - 1) = samples.position(t);
    }
    const Eigen::VectorXd c = solveTriangle(qr.triangle());
    const std::optional<MassDampingStiffness> mapped = poleMapping(c(0), c(1), c(2) + c(3) + c(4), 1.0);
    return mapped ? repaired(mapped->m, mapped->b, mapped->k) : std::nullopt;
}

} // namespace

RankedCandidates rankByResponse(const OutputErrorProblem& problem,
                                const std::vector<Eigen::Vector3d>& candidates, std::size_t most)
{
    struct Refitted {
        Eigen::Vector3d theta;
        double cost;
    };
    std::vector<Refitted> all;
    for (const Eigen::Vector3d& candidate : candidates) {
        const ResponseFit fit = fitResponse(problem, candidate);
        if (!fit.finite || !(fit.gain > 0) || fit.ownShare < smallestOwnShare)
            continue;
        // A compliance times g is M, B and K divided by g.
        const Eigen::Vector3d refitted = candidate.array() - std::log(fit.gain);
        if (refitted.allFinite())
            all.push_back({refitted, fit.costWithGain});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Refitted& a, const Refitted& b) { return a.cost < b.cost; });
    RankedCandidates ranked;
    if (!all.empty())
        ranked.leastCost = all.front().cost;
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i)
        ranked.bestFirst.push_back(all[i].theta);
    return ranked;
}

OutputErrorStarts outputErrorStarts(const OutputErrorProblem& problem)
{
    std::vector<Eigen::Vector3d> candidates;
    if (const auto theta = fromArx(problem))
        candidates.push_back(*theta);
    for (const double bandwidth : filterBandwidths) {
        if (const auto theta = fromStateVariableFilter(problem, bandwidth))
            candidates.push_back(*theta);
    }
    const RankedCandidates ranked = rankByResponse(problem, candidates, 2);
    return {ranked.bestFirst, ranked.leastCost <= poorShare * positionEnergy(problem)};
}

std::vector<Eigen::Vector3d> outputErrorGrid(const OutputErrorProblem& problem)
{
    const OutputErrorProblem part = firstSamples(problem, gridSamples);
    std::vector<Eigen::Vector3d> grid;
    const double lowest = 0.5 / static_cast<double>(part.force.size());
    for (double frequency = lowest; frequency < 3; frequency *= 1.6) {
        for (const double damping : {0.05, 0.3, 1.0, 4.0})
            grid.emplace_back(-2 * std::log(frequency), std::log(2 * damping / frequency), 0);
    }
    return rankByResponse(part, grid, 4).bestFirst;
}

} // namespace gripscope
