// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing/duffing_model.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/filter_regression.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/math/least_squares.h"
#include "core/math/sequential_qr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// K3 a^2 / K of the springs that harmonic balance makes from a linear one.
constexpr std::array<double, 6> springShares{0, -0.25, 0.2, 0.7, 2.5, 10};

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
std::optional<DuffingPoint> pointFrom(const DuffingProblem& problem, const FilterRegression& regression)
{
    const SpringCurve& c = regression.spring;
    double m = regression.mass;
    double b = regression.damping;
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
    step.head(count) = solvePivoted(linear.triangle.leftCols(count), linear.residual).solution;
    const DuffingPoint moved = point.moved(problem, step);
    const std::optional<double> better = costAt(problem, moved);
    if (better && *better < cost) {
        point = moved;
        cost = *better;
    }
}

struct DuffingCandidates : StartCandidates<DuffingPoint> {
    const DuffingProblem& problem;

    explicit DuffingCandidates(const DuffingProblem& itsProblem) : problem(itsProblem) {}
    void offer(DuffingPoint point)
    {
        std::optional<double> cost = costAt(problem, point);
        if (!cost)
            return;
        refineNuisances(problem, point, *cost);
        StartCandidates::offer(point, *cost);
    }
};

/// The step still to go, in standard errors, at which the search has arrived.
constexpr double arrivedDuffing = 1e-8;
/// Steps in the cubic spring are cut to three linear springs.
constexpr double longestCubicStep = 3;

class DuffingSearch : LevenbergMarquardt {
public:
    DuffingSearch(const DuffingProblem& problem, const DuffingPoint& start)
        : LevenbergMarquardt(squaredSize(problem), arrivedDuffing), m_problem(problem),
          m_scales(Eigen::VectorXd::Zero(problem.unknowns()))
    {
        m_result.point = start;
        m_result.linear = linearize(problem, start);
    }

    DuffingSearchResult run(int maxIterations)
    {
        if (finite())
            static_cast<SearchEnd&>(m_result) = minimise(maxIterations);
        else
            m_result.outcome = SearchOutcome::Lost;
        return m_result;
    }

private:
    bool prepare() override
    {
        m_scales = m_scales.cwiseMax(m_result.linear.triangle.colwise().norm().transpose());
        return true;
    }
    [[nodiscard]] bool finite() const override { return m_result.linear.finite; }
    [[nodiscard]] double cost() const override { return m_result.linear.cost; }
    [[nodiscard]] double degreesOfFreedom() const override { return m_result.degreesOfFreedom(m_problem); }
    [[nodiscard]] double toGo() const override { return m_result.linear.residual.norm(); }
    [[nodiscard]] Step dampedStep(double damping) const override
    {
        return dampedLeastSquares(m_result.linear.triangle, m_result.linear.residual, m_scales, damping);
    }
    [[nodiscard]] Logarithms logarithmsOf(const Step& step) const override
    {
        return step.tail<4>().head<3>();
    }
    [[nodiscard]] Logarithms logarithmDeviations() const override
    {
        const Eigen::Matrix4d inverse = inverseOfTriangle(triangleOf(m_result.linear.projected));
        return inverse.topRows<3>().rowwise().norm();
    }

    bool accept(const Step& step) override
    {
        const DuffingPoint point = m_result.point.moved(m_problem, shortening(step) * step);
        DuffingLinearization trial = linearize(m_problem, point);
        if (!trial.finite || !(trial.cost < m_result.linear.cost))
            return false;
        m_result.point = point;
        m_result.linear = std::move(trial);
        return true;
    }

    [[nodiscard]] double shortening(const Step& step) const
    {
        const double logarithms = logarithmsOf(step).cwiseAbs().maxCoeff();
        const double spring = std::max(std::exp(m_result.point.theta(2)), std::abs(m_result.point.cubic));
        const double cubic = std::abs(step(step.size() - 1)) / spring;
        return std::min({1.0, search::longestStep / std::max(logarithms, 1e-300),
                         longestCubicStep / std::max(cubic, 1e-300)});
    }

    const DuffingProblem& m_problem;
    DuffingSearchResult m_result;
    Eigen::VectorXd m_scales;
};

} // namespace

std::vector<DuffingPoint> duffingStarts(const DuffingProblem& problem,
                                        const std::vector<DuffingPoint>& others)
{
    DuffingCandidates candidates(problem);
    for (const double bandwidth : filterBandwidths) {
        const std::optional<FilterRegression> regression = filterRegression(problem, bandwidth, true);
        if (const auto point = regression ? pointFrom(problem, *regression) : std::nullopt)
            candidates.offer(*point);
    }
    const double squaredAmplitude =
        2 * positionEnergy(problem) / static_cast<double>(problem.position.size());
    for (const DuffingPoint& other : others) {
        if (other.cubic != 0) {
            candidates.offer(other);
            continue;
        }
        for (const double share : springShares) {
            DuffingPoint point = other;
            point.theta(2) -= std::log(1 + 0.75 * share);
            point.cubic = squaredAmplitude > 0 ? share * std::exp(point.theta(2)) / squaredAmplitude : 0;
            candidates.offer(point);
        }
    }
    return candidates.best();
}

bool DuffingSearchResult::isDetermined() const
{
    return linear.finite && scaledConditionNumber(linear.projected) <= largestCondition;
}

DuffingSearchResult searchDuffing(const DuffingProblem& problem, const DuffingPoint& start, int maxIterations)
{
    return DuffingSearch(problem, start).run(maxIterations);
}

} // namespace gripscope
