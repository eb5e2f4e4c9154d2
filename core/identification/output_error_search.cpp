// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error_search.h"

#include "core/identification/column_elimination.h"
#include "core/identification/scaled_record.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gripscope {

namespace {

/// The step still to go, in standard errors, at which the search has arrived.
constexpr double arrived = 1e-9;
/// Share of the position's own size below which residuals are rounding errors.
constexpr double rounding = 1e-13;
/// Steps in ln m, ln b, ln k are cut to a factor of ten.
constexpr double longestStep = 2.302585;
/// A parameter that wants to change by more than this factor (e) where the cost no longer changes has run
/// away.
constexpr double runaway = 1.0;
/// Standard error of a logarithm (a factor of 20) above which a parameter cannot be told from zero.
constexpr double undetermined = 3.0;
/// Gauss-Newton needs 5 to 15 iterations where it converges well.
constexpr int gaussNewtonIterations = 15;
/// Linearization::stale above which a second pass is worth its while, and below which the end is the end.
constexpr double tooStale = 0.01, fresh = 1e-7;
/// Share of a column that is rounding.
constexpr double dependent = 1e-15;
constexpr double smallestDamping = 1e-12, largestDamping = 1e16;

/// min |R d - c|^2 + damping |D d|^2.
Eigen::Vector3d dampedStep(const Eigen::Matrix3d& triangle, const Eigen::Vector3d& right,
                           const Eigen::Vector3d& scales, double damping)
{
    SmallMatrix stacked = SmallMatrix::Zero(6, 4);
    stacked.topLeftCorner<3, 3>() = triangle;
    stacked.block<3, 3>(3, 0) = (std::sqrt(damping) * scales).asDiagonal();
    stacked.col(3).head<3>() = right;
    return eliminateColumns(stacked, 3, dependent).solution;
}

class Search {
public:
    Search(const OutputErrorProblem& problem, const Eigen::Vector3d& start)
        : m_problem(problem), m_linearizer(problem), m_size(squaredSize(problem))
    {
        m_result.theta = start;
        m_result.linear = settledAt(start, unknownNuisance(problem));
    }

    SearchResult run(int maxIterations)
    {
        while (m_result.linear.finite && m_result.iterations < maxIterations) {
            m_scales = m_scales.cwiseMax(m_result.linear.triangle.colwise().norm().transpose());
            if (hasArrived()) {
                if (refresh())
                    continue;
                m_result.outcome = SearchOutcome::Converged;
                break;
            }
            ++m_result.iterations;
            if (isLostInRounding()) {
                if (polish() || refresh())
                    continue;
                m_result.outcome = SearchOutcome::Converged;
                break;
            }
            const bool slow = m_result.iterations > gaussNewtonIterations;
            if (!(slow && improveByNewton()) && !improve()) {
                stall();
                break;
            }
        }
        if (m_result.outcome == SearchOutcome::NotConverged && m_result.linear.finite)
            markUndetermined();
        return m_result;
    }

private:
    /// With sensitivities for the best linear unknowns: a second pass where the assumed ones were far off.
    Linearization settledAt(const Eigen::Vector3d& theta, const ScaledNuisance& assumed)
    {
        Linearization linear = m_linearizer.at(theta, assumed);
        return linear.finite && linear.stale > tooStale ? m_linearizer.at(theta, linear.nuisance) : linear;
    }

    /// Moves there when it lowers the cost.
    bool accept(const Eigen::Vector3d& step)
    {
        const Eigen::Vector3d theta = m_result.theta + step;
        Linearization trial = m_linearizer.at(theta, m_result.linear.nuisanceAfter(step));
        if (!trial.finite || !(trial.cost < m_result.linear.cost))
            return false;
        if (trial.stale > tooStale) {
            trial = m_linearizer.at(theta, trial.nuisance);
            if (!trial.finite)
                return false;
        }
        m_refreshed = false;
        m_gain = m_result.linear.cost - trial.cost;
        m_result.theta = theta;
        m_result.linear = std::move(trial);
        return true;
    }

    [[nodiscard]] double degreesOfFreedom() const
    {
        return static_cast<double>(
            std::max<std::ptrdiff_t>(m_problem.terms() - 3 - m_result.linear.nuisanceRank, 1));
    }

    /// Sensitivities for the best linear unknowns where those assumed differ; false where they don't.
    bool refresh()
    {
        if (m_refreshed || m_result.linear.stale < fresh)
            return false;
        m_refreshed = true;
        Linearization linear = m_linearizer.at(m_result.theta, m_result.linear.nuisance);
        if (!linear.finite)
            return false;
        m_result.linear = std::move(linear);
        return true;
    }

    /// |right| is the length of the step still to go, in units of the residuals.
    bool hasArrived()
    {
        const double residual = std::sqrt(m_result.linear.cost / degreesOfFreedom());
        return m_result.linear.right.norm() <=
               arrived * residual + rounding * std::sqrt(m_size / degreesOfFreedom());
    }

    /// The step lowers the cost by less than the cost is rounded, which can't be seen any more.
    bool isLostInRounding()
    {
        const Linearization& linear = m_result.linear;
        m_polish = dampedStep(linear.triangle, linear.right, m_scales, 0);
        return linear.right.squaredNorm() <= rounding * linear.cost && m_polish.cwiseAbs().maxCoeff() < 0.1;
    }

    /// Takes that step; false when less than half of what was to go is gone.
    bool polish()
    {
        const Eigen::Vector3d theta = m_result.theta + m_polish;
        Linearization trial = m_linearizer.at(theta, m_result.linear.nuisanceAfter(m_polish));
        if (!trial.finite || !(trial.right.norm() < 0.5 * m_result.linear.right.norm()))
            return false;
        m_refreshed = false;
        m_result.theta = theta;
        m_result.linear = std::move(trial);
        return true;
    }

    /// Takes the first damped step that lowers the cost; false when none does.
    bool improve()
    {
        for (; m_damping < largestDamping; m_damping *= 10) {
            Eigen::Vector3d step =
                dampedStep(m_result.linear.triangle, m_result.linear.right, m_scales, m_damping);
            const double longest = step.cwiseAbs().maxCoeff();
            if (!std::isfinite(longest))
                continue;
            step *= std::min(1.0, longestStep / std::max(longest, 1e-300));
            if (!accept(step)) {
                if (refresh())
                    m_damping /= 10; // the same again
                continue;
            }
            m_damping = std::max(m_damping / 10, smallestDamping);
            return !runsAway();
        }
        return false;
    }

    /// A Newton step with the whole Hessian, by differences of the gradient: quadratic convergence where
    /// residuals are large and the model is curved, which makes Gauss-Newton crawl. False when it does not
    /// lower the cost.
    bool improveByNewton()
    {
        Eigen::Matrix3d hessian;
        for (Eigen::Index i = 0; i < 3; ++i) {
            constexpr double step = 1e-4;
            const Eigen::Vector3d shift = step * Eigen::Vector3d::Unit(i);
            const std::optional<Eigen::Vector3d> above = gradientAt(m_result.theta + shift);
            const std::optional<Eigen::Vector3d> below = gradientAt(m_result.theta - shift);
            if (!above || !below)
                return false;
            hessian.col(i) = (*above - *below) / (2 * step);
        }
        const Eigen::Matrix3d symmetric = (hessian + hessian.transpose()) / 2;
        const Eigen::LDLT<Eigen::Matrix3d> factors(symmetric);
        if (factors.info() != Eigen::Success || !factors.isPositive())
            return false;
        const Eigen::Vector3d step =
            factors.solve(m_result.linear.triangle.transpose() * m_result.linear.right);
        if (!step.allFinite() || step.cwiseAbs().maxCoeff() > 1)
            return false;
        return accept(step);
    }

    /// Half the derivative of the cost.
    [[nodiscard]] std::optional<Eigen::Vector3d> gradientAt(const Eigen::Vector3d& theta)
    {
        const ScaledNuisance assumed = m_result.linear.nuisanceAfter(theta - m_result.theta);
        Linearization linear = m_linearizer.at(theta, assumed);
        if (linear.finite)
            linear = m_linearizer.at(theta, linear.nuisance);
        if (!linear.finite)
            return std::nullopt;
        return Eigen::Vector3d(-linear.triangle.transpose() * linear.right);
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
        const Eigen::Vector3d step = dampedStep(m_result.linear.triangle, m_result.linear.right, m_scales, 0);
        Eigen::Index index = 0;
        const double longest = step.cwiseAbs().maxCoeff(&index);
        const double residual = std::sqrt(m_result.linear.cost / degreesOfFreedom());
        if (std::isfinite(longest) && longest > runaway) {
            m_result.outcome = SearchOutcome::Boundary;
            m_result.boundaryIndex = static_cast<int>(index);
            m_result.boundaryAtZero = step(index) < 0;
        } else if (m_result.linear.right.norm() < 1e-4 * residual ||
                   m_result.linear.cost < rounding * m_size || longest < 1e-10) {
            m_result.outcome = SearchOutcome::Converged;
        }
    }

    /// A search that goes on and on along a valley ends for want of data, not of iterations: there the
    /// standard error of a logarithm is above `undetermined`.
    void markUndetermined()
    {
        const Eigen::Matrix3d inverse = m_result.linear.triangle.inverse();
        const double residual = std::sqrt(m_result.linear.cost / degreesOfFreedom());
        Eigen::Index index = 0;
        const double largest = residual * inverse.rowwise().norm().maxCoeff(&index);
        if (largest <= undetermined)
            return;
        m_result.outcome = SearchOutcome::Boundary;
        m_result.boundaryIndex = static_cast<int>(index);
        m_result.boundaryAtZero = true;
    }

    const OutputErrorProblem& m_problem;
    ResponseLinearizer m_linearizer;
    double m_size;
    SearchResult m_result;
    Eigen::Vector3d m_polish = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_scales = Eigen::Vector3d::Zero();
    double m_damping = 1e-3, m_gain = 0;
    int m_idle = 0;
    bool m_refreshed = false;
};

} // namespace

SearchResult searchOutputError(const OutputErrorProblem& problem, const Eigen::Vector3d& start,
                               int maxIterations)
{
    return Search(problem, start).run(maxIterations);
}

} // namespace gripscope
