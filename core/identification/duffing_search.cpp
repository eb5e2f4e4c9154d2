// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing_search.h"

#include "core/identification/scaled_record.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>

namespace gripscope {

namespace {

/// The step still to go, in standard errors, at which the search has arrived, and that which is good enough
/// where rounding lets it come no nearer.
constexpr double arrived = 1e-8, nearEnough = 1e-4;
/// Share of the position's own size below which residuals are rounding errors.
constexpr double rounding = 1e-13;
/// Steps in ln m, ln b, ln k are cut to a factor of ten, those in the cubic spring to three linear springs.
constexpr double longestStep = 2.302585, longestCubicStep = 3;
/// A parameter that wants to change by more than this factor (e) where the cost no longer changes has run
/// away.
constexpr double runaway = 1.0;
/// Standard error of a logarithm (a factor of 20) above which a parameter cannot be told from zero.
constexpr double undetermined = 3.0;
constexpr double smallestDamping = 1e-12, largestDamping = 1e16;

/// min |R d - c|^2 + damping |D d|^2.
Eigen::VectorXd dampedStep(const DuffingLinearization& linear, const Eigen::VectorXd& scales, double damping)
{
    const Eigen::Index n = scales.size();
    Eigen::MatrixXd stacked(2 * n, n);
    stacked.topRows(n) = linear.triangle;
    stacked.bottomRows(n) = (std::sqrt(damping) * scales).asDiagonal();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
    right.head(n) = linear.residual;
    // Columns of very different size: scale, so that the rank decision of the pivoting means something.
    const Eigen::VectorXd norms = stacked.colwise().norm().transpose().cwiseMax(1e-300);
    const Eigen::MatrixXd scaled = stacked * norms.cwiseInverse().asDiagonal();
    return norms.cwiseInverse().asDiagonal() * Eigen::VectorXd(scaled.colPivHouseholderQr().solve(right));
}

class Search {
public:
    Search(const DuffingProblem& problem, const DuffingPoint& start)
        : m_problem(problem), m_size(squaredSize(problem)),
          m_scales(Eigen::VectorXd::Zero(problem.unknowns()))
    {
        m_result.point = start;
        m_result.linear = linearize(problem, start);
    }

    DuffingSearchResult run(int maxIterations)
    {
        if (!m_result.linear.finite) {
            m_result.outcome = DuffingOutcome::Lost;
            return m_result;
        }
        while (m_result.iterations < maxIterations && !hasArrived()) {
            ++m_result.iterations;
            if (!improve()) {
                stall();
                break;
            }
        }
        if (m_result.outcome == DuffingOutcome::NotConverged)
            markUndetermined();
        return m_result;
    }

private:
    [[nodiscard]] double residualDeviation() const
    {
        return std::sqrt(m_result.linear.cost / m_result.degreesOfFreedom(m_problem));
    }

    bool hasArrived()
    {
        const double floor = rounding * std::sqrt(m_size / m_result.degreesOfFreedom(m_problem));
        if (m_result.linear.residual.norm() > arrived * residualDeviation() + floor)
            return false;
        m_result.outcome = DuffingOutcome::Converged;
        return true;
    }

    /// Takes the first damped step that lowers the cost; false when none does.
    bool improve()
    {
        m_scales = m_scales.cwiseMax(m_result.linear.triangle.colwise().norm().transpose());
        for (; m_damping < largestDamping; m_damping *= 10) {
            Eigen::VectorXd step = dampedStep(m_result.linear, m_scales, m_damping);
            if (!step.allFinite())
                continue;
            step *= shortening(step);
            const DuffingPoint point = m_result.point.moved(m_problem, step);
            const DuffingLinearization trial = linearize(m_problem, point);
            if (!trial.finite || !(trial.cost < m_result.linear.cost))
                continue;
            m_gain = m_result.linear.cost - trial.cost;
            m_result.point = point;
            m_result.linear = trial;
            m_damping = std::max(m_damping / 10, smallestDamping);
            return !runsAway();
        }
        return false;
    }

    [[nodiscard]] double shortening(const Eigen::VectorXd& step) const
    {
        const double logarithms = step.tail<4>().head<3>().cwiseAbs().maxCoeff();
        const double spring = std::max(std::exp(m_result.point.theta(2)), std::abs(m_result.point.cubic));
        const double cubic = std::abs(step(step.size() - 1)) / spring;
        return std::min(
            {1.0, longestStep / std::max(logarithms, 1e-300), longestCubicStep / std::max(cubic, 1e-300)});
    }

    /// The cost stands still while a logarithm keeps going.
    bool runsAway()
    {
        const double noise = rounding * (m_result.linear.cost + rounding * m_size);
        m_idle = m_gain < noise ? m_idle + 1 : 0;
        return m_idle >= 3;
    }

    /// No step lowers the cost any more: rounding, the end of a valley, or a runaway.
    void stall()
    {
        const Eigen::Vector3d step = dampedStep(m_result.linear, m_scales, 0).tail<4>().head<3>();
        Eigen::Index index = 0;
        const double longest = step.cwiseAbs().maxCoeff(&index);
        if (std::isfinite(longest) && longest > runaway) {
            m_result.outcome = DuffingOutcome::Boundary;
            m_result.boundaryIndex = static_cast<int>(index);
            m_result.boundaryAtZero = step(index) < 0;
        } else if (m_result.linear.residual.norm() < nearEnough * residualDeviation() ||
                   m_result.linear.cost < rounding * m_size || longest < 1e-10) {
            m_result.outcome = DuffingOutcome::Converged;
        }
    }

    /// A search that goes on and on along a valley ends for want of data, not of iterations: there the
    /// standard error of a logarithm is above `undetermined`.
    void markUndetermined()
    {
        const Eigen::Matrix4d triangle =
            Eigen::HouseholderQR<Eigen::MatrixXd>(m_result.linear.projected).matrixQR().topRows<4>();
        const Eigen::Matrix4d inverse = Eigen::Matrix4d(triangle.triangularView<Eigen::Upper>()).inverse();
        Eigen::Index index = 0;
        const double largest = residualDeviation() * inverse.topRows<3>().rowwise().norm().maxCoeff(&index);
        if (largest <= undetermined)
            return;
        m_result.outcome = DuffingOutcome::Boundary;
        m_result.boundaryIndex = static_cast<int>(index);
        m_result.boundaryAtZero = true;
    }

    const DuffingProblem& m_problem;
    double m_size;
    DuffingSearchResult m_result;
    Eigen::VectorXd m_scales;
    double m_damping = 1e-3, m_gain = 0;
    int m_idle = 0;
};

} // namespace

DuffingSearchResult searchDuffing(const DuffingProblem& problem, const DuffingPoint& start, int maxIterations)
{
    return Search(problem, start).run(maxIterations);
}

} // namespace gripscope
