// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing_start.h"

#include "core/identification/second_order_filter.h"
#include "core/identification/tall_qr.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

/// Bandwidths of the filters in radians a sample.
constexpr std::array<double, 5> filterBandwidths{0.01, 0.03, 0.1, 0.3, 1.0};
/// K3 a^2 / K of the springs that harmonic balance makes from a linear one.
constexpr std::array<double, 6> cubicShares{0, -0.25, 0.2, 0.7, 2.5, 10};
constexpr std::size_t mostStarts = 3;

/// Least-squares solution of the triangle whose last column is the right-hand side.
Eigen::VectorXd solveTriangle(const Eigen::MatrixXd& triangle)
{
    const Eigen::Index n = triangle.cols() - 1;
    Eigen::MatrixXd left = triangle.topLeftCorner(n, n);
    Eigen::VectorXd scales(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double norm = left.col(i).norm();
        scales(i) = norm > 0 ? 1 / norm : 0;
        left.col(i) *= scales(i);
    }
    return scales.asDiagonal() *
           Eigen::VectorXd(left.colPivHouseholderQr().solve(triangle.topRightCorner(n, 1)));
}

/// The spring's force at a position y: c[0] + c[1] y + c[2] y^2 + c[3] y^3.
using SpringCurve = std::array<double, 4>;

/// The position without force next to zero, by Newton's method; zero where that leads nowhere.
double restPosition(const SpringCurve& c)
{
    double y = 0;
    for (int i = 0; i < 20; ++i) {
        const double slope = c[1] + y * (2 * c[2] + 3 * y * c[3]);
        y -= (c[0] + y * (c[1] + y * (c[2] + y * c[3]))) / slope;
    }
    return std::abs(y) < 10 ? y : 0;
}

/// An impossible sign of M or B replaced by something small: the search will see to it.
std::optional<DuffingPoint> pointFrom(const DuffingProblem& problem, double m, double b, const SpringCurve& c)
{
    DuffingPoint point;
    point.offset = problem.freeOffset ? restPosition(c) : 0;
    double k = c[1] + point.offset * (2 * c[2] + 3 * point.offset * c[3]);
    if (!(k > 0))
        k = c[1];
    if (!std::isfinite(m) || !std::isfinite(b) || !(k > 0))
        return std::nullopt;
    if (!(m > 0))
        m = b > 0 ? 0.1 * b * b / k : k;
    if (!(b > 0))
        b = 0.1 * std::sqrt(m * k);
    point.theta = {std::log(m), std::log(b), std::log(k)};
    point.cubic = c[3];
    if (problem.freeInitialState)
        point.x0 = problem.position.front() - point.offset;
    return point.finite() ? std::optional(point) : std::nullopt;
}

/// Position and force at the same time index, the lag rounded to whole samples.
struct AlignedSamples {
    const DuffingProblem& problem;
    std::ptrdiff_t shift, count;

    explicit AlignedSamples(const DuffingProblem& p)
        : problem(p), shift(p.lag.samples + (p.lag.rest >= 0.5 ? 1 : 0)),
          count(static_cast<std::ptrdiff_t>(p.force.size()) - std::abs(shift))
    {
    }
    [[nodiscard]] double force(std::ptrdiff_t t) const
    {
        return problem.force[static_cast<std::size_t>(t + std::max<std::ptrdiff_t>(shift, 0))];
    }
    [[nodiscard]] double position(std::ptrdiff_t t) const
    {
        return problem.position[static_cast<std::size_t>(t + std::max<std::ptrdiff_t>(-shift, 0))];
    }
};

std::optional<DuffingPoint> fromFilters(const DuffingProblem& problem, double bandwidth)
{
    const AlignedSamples samples(problem);
    const double squared = bandwidth * bandwidth;
    SecondOrderFilter force(squared, 2 * bandwidth, problem.hold);
    std::array<SecondOrderFilter, 3> powers;
    powers.fill(SecondOrderFilter(squared, 2 * bandwidth, ForceHold::First));
    const Eigen::Index columns = problem.freeOffset ? 8 : 6;
    TallQr qr(columns + 1);
    for (std::ptrdiff_t t = 0; t < samples.count; ++t) {
        const double y = samples.position(t);
        const double decay = std::exp(-bandwidth * static_cast<double>(t));
        auto row = qr.nextRow();
        row.head<6>() << powers[0].curvature(y), powers[0].slope(), powers[0].value(), powers[2].value(),
            decay, decay * bandwidth * static_cast<double>(t);
        if (problem.freeOffset) {
            row(6) = powers[1].value();
            row(7) = 1;
        }
        row(columns) = force.value();
        const std::ptrdiff_t after = std::min(t + 1, samples.count - 1);
        const double next = samples.position(after);
        force.advance(samples.force(t), samples.force(after));
        powers[0].advance(y, next);
        powers[1].advance(y * y, next * next);
        powers[2].advance(y * y * y, next * next * next);
    }
    const Eigen::VectorXd c = solveTriangle(qr.triangle());
    const bool offset = problem.freeOffset;
    return pointFrom(problem, c(0), c(1), {offset ? c(7) : 0, c(2), offset ? c(6) : 0, c(3)});
}

/// The nuisances of a candidate from one linear least-squares step, if that makes it better.
void refineNuisances(const DuffingProblem& problem, DuffingPoint& point, double& cost)
{
    const Eigen::Index count = problem.nuisanceCount();
    if (count == 0)
        return;
    const DuffingLinearization linear = linearize(problem, point);
    if (!linear.finite)
        return;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(problem.unknowns());
    step.head(count) =
        Eigen::MatrixXd(linear.triangle.leftCols(count)).colPivHouseholderQr().solve(linear.residual);
    const DuffingPoint moved = point.moved(problem, step);
    const std::optional<double> better = costAt(problem, moved);
    if (better && *better < cost) {
        point = moved;
        cost = *better;
    }
}

struct Candidates {
    struct Candidate {
        DuffingPoint point;
        double cost;
    };
    const DuffingProblem& problem;
    std::vector<Candidate> all;

    void offer(DuffingPoint point)
    {
        std::optional<double> cost = costAt(problem, point);
        if (!cost)
            return;
        refineNuisances(problem, point, *cost);
        all.push_back({point, *cost});
    }
};

} // namespace

double positionEnergy(const DuffingProblem& problem)
{
    double mean = 0;
    double squares = 0;
    for (const double y : problem.position) {
        mean += y;
        squares += y * y;
    }
    const auto count = static_cast<double>(problem.position.size());
    return squares - (problem.freeOffset ? mean * mean / count : 0);
}

std::vector<DuffingPoint> duffingStarts(const DuffingProblem& problem,
                                        const std::vector<DuffingPoint>& others)
{
    Candidates candidates{problem, {}};
    for (const double bandwidth : filterBandwidths) {
        if (const std::optional<DuffingPoint> point = fromFilters(problem, bandwidth))
            candidates.offer(*point);
    }
    const double squaredAmplitude =
        2 * positionEnergy(problem) / static_cast<double>(problem.position.size());
    for (const DuffingPoint& other : others) {
        if (other.cubic != 0) {
            candidates.offer(other);
            continue;
        }
        for (const double share : cubicShares) {
            DuffingPoint point = other;
            point.theta(2) -= std::log(1 + 0.75 * share);
            point.cubic = squaredAmplitude > 0 ? share * std::exp(point.theta(2)) / squaredAmplitude : 0;
            candidates.offer(point);
        }
    }
    std::stable_sort(candidates.all.begin(), candidates.all.end(),
                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
    std::vector<DuffingPoint> best;
    for (std::size_t i = 0; i < std::min(mostStarts, candidates.all.size()); ++i)
        best.push_back(candidates.all[i].point);
    return best;
}

} // namespace gripscope
