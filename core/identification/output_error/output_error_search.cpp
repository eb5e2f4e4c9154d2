// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error_search.h"

#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/math/decompositions.h"
#include "core/math/sequential_qr.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gripscope {

namespace {

/// Gauss-Newton needs 5 to 15 iterations where it converges well.
constexpr int gaussNewtonIterations = 15;
/// Linearization::stale above which a second pass is worth its while, and below which the end is the end.
constexpr double tooStale = 0.01, fresh = 1e-7;
/// Share of a column that is rounding.
constexpr double columnRounding = 1e-15;

class OutputErrorSearch : LevenbergMarquardt {
public:
    OutputErrorSearch(const OutputErrorProblem& problem, const Eigen::Vector3d& start, double arrived)
        : LevenbergMarquardt(squaredSize(problem), arrived), m_problem(problem), m_linearizer(problem)
    {
        m_result.theta = start;
        m_result.linear = settledAt(start, unknownNuisance(problem));
    }

    SearchResult run(int maxIterations)
    {
        static_cast<SearchEnd&>(m_result) = minimise(maxIterations);
        return m_result;
    }

private:
    /// With sensitivities for the best linear unknowns: a second pass where the assumed ones were far off.
    Linearization settledAt(const Eigen::Vector3d& theta, const ScaledNuisance& assumed)
    {
        Linearization linear = m_linearizer.at(theta, assumed);
        return linear.finite && linear.stale > tooStale ? m_linearizer.at(theta, linear.nuisance) : linear;
    }

    bool prepare() override
    {
        if (m_result.linear.finite)
            m_scales = m_scales.cwiseMax(m_result.linear.triangle.colwise().norm().transpose());
        return m_result.linear.finite;
    }
    [[nodiscard]] bool finite() const override { return m_result.linear.finite; }
    [[nodiscard]] double cost() const override { return m_result.linear.cost; }
    [[nodiscard]] double toGo() const override { return m_result.linear.right.norm(); }

    [[nodiscard]] Step dampedStep(double damping) const override
    {
        SmallMatrix stacked = SmallMatrix::Zero(6, 4);
        stacked.topLeftCorner<3, 3>() = m_result.linear.triangle;
        stacked.block<3, 3>(3, 0) = (std::sqrt(damping) * m_scales).asDiagonal();
        stacked.col(3).head<3>() = m_result.linear.right;
        return eliminateColumns(stacked, 3, columnRounding).solution;
    }
    [[nodiscard]] Logarithms logarithmDeviations() const override
    {
        const Eigen::Matrix3d inverse = m_result.linear.triangle.inverse();
        return inverse.rowwise().norm();
    }

    bool accept(const Step& whole) override
    {
        const double longest = whole.cwiseAbs().maxCoeff();
        const Eigen::Vector3d step = std::min(1.0, search::longestStep / std::max(longest, 1e-300)) * whole;
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
        m_result.theta = theta;
        m_result.linear = std::move(trial);
        return true;
    }

    [[nodiscard]] double degreesOfFreedom() const override
    {
        return static_cast<double>(
            std::max<std::ptrdiff_t>(m_problem.terms() - 3 - m_result.linear.nuisanceRank, 1));
    }

    /// Sensitivities for the best linear unknowns where those assumed differ; false where they don't.
    bool refresh() override
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

    bool isLostInRounding() override
    {
        const Linearization& linear = m_result.linear;
        m_polish = dampedStep(0);
        return linear.right.squaredNorm() <= search::rounding * linear.cost &&
               m_polish.cwiseAbs().maxCoeff() < 0.1;
    }

    /// False when less than half of what was to go is gone.
    bool polish() override
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

    bool improve() override
    {
        const bool slow = iterations() > gaussNewtonIterations;
        return (slow && improveByNewton()) || LevenbergMarquardt::improve();
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

    const OutputErrorProblem& m_problem;
    ResponseLinearizer m_linearizer;
    SearchResult m_result;
    Eigen::Vector3d m_polish = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_scales = Eigen::Vector3d::Zero();
    bool m_refreshed = false;
};

} // namespace

bool SearchResult::isDetermined() const
{
    return linear.finite && linear.ownShare >= smallestOwnShare &&
           scaledConditionNumber(linear.triangle) <= largestCondition;
}

bool SearchResult::isSettled() const
{
    return outcome == SearchOutcome::Converged && isDetermined();
}

SearchResult searchOutputError(const OutputErrorProblem& problem, const Eigen::Vector3d& start,
                               int maxIterations, double arrived)
{
    return OutputErrorSearch(problem, start, arrived).run(maxIterations);
}

} // namespace gripscope
