// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/instrumental/instrumental_variables.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/filter_regression.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/identification/output_error/output_error_search.h"
#include "core/math/least_squares.h"
#include "core/math/sequential_qr.h"

#include <Eigen/LU>

#include <cmath>
#include <complex>

namespace gripscope {

namespace {

/// The step still to go, in standard errors, at which the iteration has arrived.
constexpr double arrivedIteration = 1e-8;
constexpr int mostStepHalvings = 4;
/// Less damping than this share of the critical is taken for an error of the first estimate.
constexpr double leastDamping = 0.01;

class Iteration : LevenbergMarquardt {
public:
    Iteration(const OutputErrorProblem& record, const Eigen::Vector3d& start)
        : LevenbergMarquardt(squaredSize(record), arrivedIteration), m_record(record)
    {
        m_result.model = auxiliaryModel(record, start);
    }
    InstrumentalResult run(int maxIterations)
    {
        static_cast<SearchEnd&>(m_result) = minimise(maxIterations);
        return m_result;
    }

private:
    bool prepare() override
    {
        if (!m_result.model.finite)
            return false;
        m_result.equations = instrumentalEquations(m_record, m_result.model);
        if (!m_result.equations.finite)
            return false;
        Eigen::MatrixXd right(m_result.equations.regressors.rows(), 4);
        right << m_result.equations.regressors, m_result.equations.residual;
        const Triangularized qr = triangularize(m_result.equations.instruments, right);
        m_triangle = qr.triangle;
        m_result.cross = qr.right.topLeftCorner<3, 3>();
        m_right = qr.right.topRightCorner<3, 1>();
        m_scales = m_scales.cwiseMax(m_triangle.colwise().norm().transpose());
        return true;
    }
    [[nodiscard]] bool finite() const override { return m_result.equations.finite; }
    [[nodiscard]] double cost() const override { return m_result.model.cost; }
    [[nodiscard]] double degreesOfFreedom() const override { return m_result.degreesOfFreedom(m_record); }
    [[nodiscard]] double toGo() const override { return m_right.norm(); }
    [[nodiscard]] Step dampedStep(double damping) const override
    {
        return dampedLeastSquares(m_triangle, -m_right, m_scales, damping);
    }
    [[nodiscard]] Logarithms logarithmDeviations() const override
    {
        const Eigen::Matrix3d inverse = m_triangle.inverse();
        return inverse.rowwise().norm();
    }
    bool accept(const Step& step) override
    {
        if (!step.allFinite())
            return false;
        const double cut = std::min(1.0, search::longestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-300));
        const AuxiliaryModel trial = auxiliaryModel(m_record, m_result.model.theta + cut * step);
        if (!trial.finite || !(trial.cost < m_result.model.cost))
            return false;
        const double gain = m_result.model.cost - trial.cost;
        m_idle = gain < search::rounding * (m_result.model.cost + search::rounding * m_size) ? m_idle + 1 : 0;
        m_result.model = trial;
        return true;
    }
    bool improve() override { return m_idle < 3 && (improveByInstruments() || improveByDamping()); }
    /// The solution of the instrumental-variable equations, or a part of the way to it.
    bool improveByInstruments()
    {
        const Eigen::Vector3d change = -solvePivoted(m_result.cross, m_right).solution;
        Eigen::Vector3d step = change.unaryExpr(
            [](double share) { return share > -0.9 ? std::log1p(share) : -search::longestStep; });
        for (int i = 0; i < mostStepHalvings; ++i, step /= 2) {
            if (accept(step))
                return true;
        }
        return false;
    }

    const OutputErrorProblem& m_record;
    InstrumentalResult m_result;
    Eigen::Matrix3d m_triangle = Eigen::Matrix3d::Zero();
    Eigen::Vector3d m_right = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_scales = Eigen::Vector3d::Zero();
    int m_idle = 0;
};

/// M s^2 + B s + K with the roots of the right half plane reflected and the damping at least a share of the
/// critical; nothing when it is no equation of the second order.
std::optional<Eigen::Vector3d> reflected(const FilterRegression& regression)
{
    const double mass = regression.mass;
    const double sum = -regression.damping / mass; // of the roots
    const double product = regression.spring[1] / mass;
    if (!std::isfinite(sum) || !std::isfinite(product) || product == 0)
        return std::nullopt;
    const std::complex<double> root = std::sqrt(std::complex<double>(sum * sum / 4 - product));
    const double first = std::abs((sum / 2 + root).real());
    const double second = std::abs((sum / 2 - root).real());
    const double frequency = std::sqrt(std::abs(product));
    const double damping = std::max(first + second, 2 * leastDamping * frequency);
    const double stiffness = std::abs(regression.spring[1]);
    const Eigen::Vector3d theta(std::log(stiffness) - 2 * std::log(frequency),
                                std::log(stiffness) + std::log(damping) - 2 * std::log(frequency),
                                std::log(stiffness));
    return theta.allFinite() ? std::optional(theta) : std::nullopt;
}

} // namespace

bool InstrumentalResult::isDetermined() const
{
    return model.finite && equations.finite && model.ownShare >= smallestOwnShare &&
           scaledConditionNumber(equations.instruments) <= largestCondition;
}

InstrumentalResult iterateInstruments(const OutputErrorProblem& record, const Eigen::Vector3d& start,
                                      int maxIterations)
{
    return Iteration(record, start).run(maxIterations);
}

std::vector<Eigen::Vector3d> instrumentalStarts(const OutputErrorProblem& record)
{
    std::vector<Eigen::Vector3d> candidates;
    for (const double bandwidth : filterBandwidths) {
        const std::optional<FilterRegression> regression = filterRegression(record, bandwidth, false);
        const std::optional<Eigen::Vector3d> theta = regression ? reflected(*regression) : std::nullopt;
        if (theta)
            candidates.push_back(*theta);
    }
    return rankByResponse(record, candidates, 2).bestFirst;
}

} // namespace gripscope
