// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/instrumental_variables_search.h"

#include "core/identification/filter_regression.h"
#include "core/identification/output_error_start.h"
#include "core/identification/scaled_record.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <complex>

namespace gripscope {

namespace {

/// The step still to go, in standard errors, at which the iteration has arrived, and that which is good
/// enough where rounding lets it come no nearer.
constexpr double arrived = 1e-8, nearEnough = 1e-4;
/// Share of the position's own size below which residuals are rounding errors.
constexpr double rounding = 1e-13;
/// Steps in ln m, ln b, ln k are cut to a factor of ten.
constexpr double longestStep = 2.302585;
/// Where no step lowers the cost, one that still wants to go further than this factor (e) has run away.
constexpr double runaway = 1.0;
/// Standard error of a logarithm (a factor of 20) above which a parameter cannot be told from zero.
constexpr double undetermined = 3.0;
constexpr int halvings = 4;
constexpr double smallestDamping = 1e-12, largestDamping = 1e16;
/// Less damping than this share of the critical is taken for an error of the first estimate.
constexpr double leastDamping = 0.01;

class Iteration {
public:
    Iteration(const ScaledRecord& record, const Eigen::Vector3d& start)
        : m_record(record), m_size(squaredSize(record))
    {
        m_result.model = auxiliaryModel(record, start);
    }
    InstrumentalResult run(int maxIterations)
    {
        while (m_result.model.finite && m_result.iterations < maxIterations) {
            if (!solveHere() || hasArrived())
                break;
            ++m_result.iterations;
            if (!improveByInstruments() && !improveByGaussNewton()) {
                stall();
                break;
            }
        }
        if (m_result.outcome == InstrumentalOutcome::NotConverged && m_result.equations.finite)
            markUndetermined();
        return m_result;
    }

private:
    bool solveHere()
    {
        m_result.equations = instrumentalEquations(m_record, m_result.model);
        if (!m_result.equations.finite)
            return false;
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(m_result.equations.instruments);
        m_triangle = qr.matrixQR().topRows(3).triangularView<Eigen::Upper>();
        Eigen::MatrixXd right(m_result.equations.regressors.rows(), 4);
        right << m_result.equations.regressors, m_result.equations.residual;
        right.applyOnTheLeft(qr.householderQ().adjoint());
        m_result.cross = right.topLeftCorner<3, 3>();
        m_right = right.topRightCorner<3, 1>();
        m_scales = m_scales.cwiseMax(m_triangle.colwise().norm().transpose());
        return true;
    }
    [[nodiscard]] double residualDeviation() const
    {
        return std::sqrt(m_result.model.cost / m_result.degreesOfFreedom(m_record));
    }
    bool hasArrived()
    {
        const double floor = rounding * std::sqrt(m_size / m_result.degreesOfFreedom(m_record));
        if (m_right.norm() > arrived * residualDeviation() + floor)
            return false;
        m_result.outcome = InstrumentalOutcome::Converged;
        return true;
    }
    bool accept(const Eigen::Vector3d& step)
    {
        if (!step.allFinite())
            return false;
        const double cut = std::min(1.0, longestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-300));
        const AuxiliaryModel trial = auxiliaryModel(m_record, m_result.model.theta + cut * step);
        if (!trial.finite || !(trial.cost < m_result.model.cost))
            return false;
        const double gain = m_result.model.cost - trial.cost;
        m_idle = gain < rounding * (m_result.model.cost + rounding * m_size) ? m_idle + 1 : 0;
        m_result.model = trial;
        return true;
    }
    /// The solution of the instrumental-variable equations, or a part of the way to it.
    bool improveByInstruments()
    {
        if (m_idle >= 3)
            return false;
        const Eigen::Vector3d change = -m_result.cross.colPivHouseholderQr().solve(m_right);
        Eigen::Vector3d step =
            change.unaryExpr([](double share) { return share > -0.9 ? std::log1p(share) : -longestStep; });
        for (int i = 0; i < halvings; ++i, step /= 2) {
            if (accept(step))
                return true;
        }
        return false;
    }
    /// Levenberg-Marquardt with the instruments for regressors.
    bool improveByGaussNewton()
    {
        if (m_idle >= 3)
            return false;
        for (; m_damping < largestDamping; m_damping *= 10) {
            if (accept(dampedStep(m_damping))) {
                m_damping = std::max(m_damping / 10, smallestDamping);
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] Eigen::Vector3d dampedStep(double damping) const
    {
        Eigen::Matrix<double, 6, 3> stacked;
        stacked.topRows<3>() = m_triangle;
        stacked.bottomRows<3>() = (std::sqrt(damping) * m_scales).asDiagonal();
        Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
        right.head<3>() = -m_right;
        const Eigen::Vector3d norms = stacked.colwise().norm().transpose().cwiseMax(1e-300);
        const Eigen::Matrix<double, 6, 3> scaled = stacked * norms.cwiseInverse().asDiagonal();
        return norms.cwiseInverse().asDiagonal() * Eigen::Vector3d(scaled.colPivHouseholderQr().solve(right));
    }
    /// No step lowers the cost any more: rounding, the end of a valley, or a runaway.
    void stall()
    {
        const Eigen::Vector3d step = dampedStep(0);
        Eigen::Index index = 0;
        const double longest = step.cwiseAbs().maxCoeff(&index);
        if (std::isfinite(longest) && longest > runaway) {
            m_result.outcome = InstrumentalOutcome::Boundary;
            m_result.boundaryIndex = static_cast<int>(index);
            m_result.boundaryAtZero = step(index) < 0;
        } else if (m_right.norm() < nearEnough * residualDeviation() ||
                   m_result.model.cost < rounding * m_size || longest < 1e-10) {
            m_result.outcome = InstrumentalOutcome::Converged;
        }
    }
    /// An iteration that goes on and on along a valley ends for want of data, not of steps.
    void markUndetermined()
    {
        const Eigen::Matrix3d inverse = m_triangle.inverse();
        Eigen::Index index = 0;
        const double largest = residualDeviation() * inverse.rowwise().norm().maxCoeff(&index);
        if (largest <= undetermined)
            return;
        m_result.outcome = InstrumentalOutcome::Boundary;
        m_result.boundaryIndex = static_cast<int>(index);
        m_result.boundaryAtZero = true;
    }

    const ScaledRecord& m_record;
    double m_size;
    InstrumentalResult m_result;
    Eigen::Matrix3d m_triangle = Eigen::Matrix3d::Zero();
    Eigen::Vector3d m_right = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_scales = Eigen::Vector3d::Zero();
    double m_damping = 1e-3;
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

InstrumentalResult iterateInstruments(const ScaledRecord& record, const Eigen::Vector3d& start,
                                      int maxIterations)
{
    return Iteration(record, start).run(maxIterations);
}

std::vector<Eigen::Vector3d> instrumentalStarts(const ScaledRecord& record)
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
