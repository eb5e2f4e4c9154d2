// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error_model.h"

#include "core/identification/exact_step.h"
#include "core/identification/tall_qr.h"

#include <Eigen/QR>

#include <cmath>

namespace gripscope {

namespace {

/// Columns whose angle to the others is below this are taken for dependent: rounding makes it about 1e-15.
constexpr double dependent = 1e-12;

/// Far below anything that counts beside positions of about 1, far above denormal numbers and their squares.
constexpr double vanishing = 1e-150;

/// M, B, K as the matrices need them. Velocities are counted in units of `speed`, the natural frequency where
/// that is above one radian a sample, so that the matrices stay balanced.
struct Dynamics {
    double stiffness, damping, compliance, speed;

    explicit Dynamics(const Eigen::Vector3d& theta)
        : stiffness(std::exp(theta(2) - theta(0))), damping(std::exp(theta(1) - theta(0))),
          compliance(std::exp(-theta(0))), speed(std::max(1.0, std::sqrt(stiffness)))
    {
    }
    [[nodiscard]] bool finite() const
    {
        return std::isfinite(stiffness) && std::isfinite(damping) && std::isfinite(compliance) &&
               compliance > 0;
    }
    /// Of the state (x, x' / speed).
    [[nodiscard]] Eigen::Matrix2d motion() const
    {
        Eigen::Matrix2d a;
        a << 0, speed, -stiffness / speed, -damping;
        return a;
    }
    /// Of the state (x, x'/speed, w speed^2, w' speed), w'' + (B/M) w' + (K/M) w = x.
    [[nodiscard]] Eigen::Matrix4d cascade() const
    {
        Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
        a.topLeftCorner<2, 2>() = motion();
        a.bottomRightCorner<2, 2>() = motion();
        a(3, 0) = speed;
        return a;
    }
};

/// exactStep() over the share `part` of a sample for a force of size 1 / M.
template <int N>
ExactStep<N> stepOver(const Eigen::Matrix<double, N, N>& a, double part, const Dynamics& dynamics,
                      ForceHold hold)
{
    Eigen::Matrix<double, N, 1> b = Eigen::Matrix<double, N, 1>::Zero();
    b(1) = part / dynamics.speed;
    ExactStep<N> step = exactStep<N>(a * part, b, hold);
    step.gamma0 *= dynamics.compliance;
    step.gamma1 *= dynamics.compliance;
    return step;
}

/// Runs a state of N numbers through the record, sample by sample, and shows it at the times of the
/// positions.
template <int N>
class Recursion {
public:
    Recursion(const OutputErrorProblem& problem, const Eigen::Matrix<double, N, N>& a,
              const Dynamics& dynamics)
        : m_problem(problem), m_step(stepOver<N>(a, 1, dynamics, problem.hold)),
          m_part(stepOver<N>(a, problem.lag.rest, dynamics, problem.hold))
    {
    }
    void advance(Eigen::Matrix<double, N, 1>& state, std::ptrdiff_t n) const
    {
        state = (m_step.phi * state + m_step.gamma0 * force(n) + m_step.gamma1 * force(n + 1)).eval();
        // Without force it decays; zero is faster than the denormal numbers it would end in.
        if (state.cwiseAbs().maxCoeff() < vanishing)
            state.setZero();
    }
    /// The state at time n + rest.
    [[nodiscard]] Eigen::Matrix<double, N, 1> within(const Eigen::Matrix<double, N, 1>& state,
                                                     std::ptrdiff_t n) const
    {
        const double rest = m_problem.lag.rest;
        if (rest == 0)
            return state;
        const double end = (1 - rest) * force(n) + rest * force(n + 1);
        return m_part.phi * state + m_part.gamma0 * force(n) + m_part.gamma1 * end;
    }
    [[nodiscard]] const Eigen::Matrix<double, N, N>& phi() const { return m_step.phi; }
    [[nodiscard]] const Eigen::Matrix<double, N, N>& partPhi() const { return m_part.phi; }

private:
    [[nodiscard]] double force(std::ptrdiff_t n) const
    {
        const auto last = static_cast<std::ptrdiff_t>(m_problem.force.size()) - 1;
        return m_problem.force[static_cast<std::size_t>(std::min(n, last))];
    }
    const OutputErrorProblem& m_problem;
    ExactStep<N> m_step, m_part;
};

/// What a unit of x0 and of v0 adds to the position: the first row of phi^n.
class FreeResponses {
public:
    FreeResponses(const Eigen::Matrix2d& phi, const Eigen::Matrix2d& partPhi, double speed)
        : m_phi(phi), m_part(partPhi), m_speed(speed)
    {
    }
    void advance()
    {
        m_power = (m_power * m_phi).eval();
        if (m_power.cwiseAbs().maxCoeff() < vanishing)
            m_power.setZero();
    }
    /// d x / d x0 and d x / d v0.
    [[nodiscard]] Eigen::RowVector2d position() const
    {
        const Eigen::RowVector2d x = m_part.row(0) * m_power;
        return {x(0), x(1) / m_speed};
    }

private:
    Eigen::Matrix2d m_phi, m_part;
    double m_speed;
    Eigen::Matrix2d m_power = Eigen::Matrix2d::Identity();
};

/// Splits a triangle whose first `count` columns are nuisances: what is left of the other columns when
/// everything that the nuisances explain is taken out, and the solution for the nuisances themselves.
struct NuisanceProjection {
    Eigen::MatrixXd rest;     ///< other columns, projected; its rows are orthonormal coordinates
    Eigen::MatrixXd solution; ///< count x others: the nuisances that explain each of the others best
    int rank = 0;

    NuisanceProjection(const Eigen::MatrixXd& triangle, Eigen::Index count)
    {
        const Eigen::Index others = triangle.cols() - count;
        if (count == 0) {
            rest = triangle;
            solution.resize(0, others);
            return;
        }
        Eigen::MatrixXd nuisances = triangle.leftCols(count);
        Eigen::VectorXd scales(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const double norm = nuisances.col(i).norm();
            scales(i) = norm > 0 ? 1 / norm : 0;
            nuisances.col(i) *= scales(i);
        }
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(nuisances);
        qr.setThreshold(dependent);
        rank = static_cast<int>(qr.rank());
        const Eigen::MatrixXd rotated = qr.householderQ().adjoint() * triangle.rightCols(others);
        rest = rotated.bottomRows(rotated.rows() - rank);
        solution = scales.asDiagonal() * qr.solve(Eigen::MatrixXd(triangle.rightCols(others)));
    }
};

void readNuisance(const OutputErrorProblem& problem, const Eigen::VectorXd& solution,
                  ScaledNuisance& nuisance)
{
    Eigen::Index at = 0;
    if (problem.freeInitialState) {
        nuisance.x0 = solution(at++);
        nuisance.v0 = solution(at++);
    }
    if (problem.freeOffset)
        nuisance.offset = solution(at);
}

} // namespace

std::ptrdiff_t OutputErrorProblem::firstRow() const
{
    return std::max<std::ptrdiff_t>(-lag.samples, 0);
}

std::ptrdiff_t OutputErrorProblem::endRow() const
{
    const auto count = static_cast<std::ptrdiff_t>(force.size());
    // Within the last step a straight force would need the sample after it.
    const std::ptrdiff_t unknown = lag.rest > 0 && hold == ForceHold::First ? 1 : 0;
    return std::min(count - lag.samples - unknown, count);
}

MassDampingStiffness OutputErrorProblem::toChannelUnits(const Eigen::Vector3d& theta) const
{
    const double scale = forceScale / positionScale;
    return {std::exp(theta(0)) * sampleTime_s * sampleTime_s * scale,
            std::exp(theta(1)) * sampleTime_s * scale, std::exp(theta(2)) * scale};
}

Eigen::Vector3d OutputErrorProblem::toTheta(const MassDampingStiffness& parameters) const
{
    const double scale = std::log(forceScale / positionScale);
    const double time = std::log(sampleTime_s);
    return {std::log(parameters.m) - 2 * time - scale, std::log(parameters.b) - time - scale,
            std::log(parameters.k) - scale};
}

ResponseFit fitResponse(const OutputErrorProblem& problem, const Eigen::Vector3d& theta)
{
    ResponseFit fit;
    const Dynamics dynamics(theta);
    if (!dynamics.finite())
        return fit;
    const Recursion<2> recursion(problem, dynamics.motion(), dynamics);
    FreeResponses free(recursion.phi(), recursion.partPhi(), dynamics.speed);
    const int nuisances = problem.nuisanceCount();
    TallQr qr(nuisances + 2);
    Eigen::Vector2d state = Eigen::Vector2d::Zero();
    const std::ptrdiff_t begin = problem.firstRow() + problem.lag.samples;
    const std::ptrdiff_t end = problem.endRow() + problem.lag.samples;
    for (std::ptrdiff_t n = 0; n < end; ++n) {
        if (n >= begin) {
            auto row = qr.nextRow();
            if (problem.freeInitialState)
                row.head<2>() = free.position();
            if (problem.freeOffset)
                row(nuisances - 1) = 1;
            row(nuisances) = recursion.within(state, n)(0);
            row(nuisances + 1) = problem.position[static_cast<std::size_t>(n - problem.lag.samples)];
        }
        recursion.advance(state, n);
        free.advance();
    }
    const Eigen::MatrixXd triangle = qr.triangle();
    if (!triangle.allFinite())
        return fit;
    const NuisanceProjection projection(triangle, nuisances);
    const Eigen::VectorXd forced = projection.rest.col(0);
    const Eigen::VectorXd measured = projection.rest.col(1);
    const double power = forced.squaredNorm();
    fit.gain = power > 0 ? forced.dot(measured) / power : 0;
    const double rawPower = triangle.col(nuisances).squaredNorm();
    fit.ownShare = rawPower > 0 ? std::sqrt(power / rawPower) : 0;
    fit.cost = (measured - forced).squaredNorm();
    fit.costWithGain = (measured - fit.gain * forced).squaredNorm();
    fit.nuisanceRank = projection.rank;
    if (nuisances > 0)
        readNuisance(problem, projection.solution.col(1) - projection.solution.col(0), fit.nuisance);
    fit.finite = std::isfinite(fit.cost) && std::isfinite(fit.costWithGain);
    return fit;
}

void forEachLinearizedRow(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                          const ScaledNuisance& nuisance,
                          const std::function<void(std::ptrdiff_t, const Eigen::RowVectorXd&)>& use)
{
    const Dynamics dynamics(theta);
    const Recursion<4> recursion(problem, dynamics.cascade(), dynamics);
    FreeResponses free(recursion.phi().topLeftCorner<2, 2>(), recursion.partPhi().topLeftCorner<2, 2>(),
                       dynamics.speed);
    const double squaredSpeed = dynamics.speed * dynamics.speed;
    const int nuisances = problem.nuisanceCount();
    Eigen::RowVectorXd row(nuisances + 4);
    Eigen::Vector4d state(nuisance.x0, nuisance.v0 / dynamics.speed, 0, 0);
    const std::ptrdiff_t begin = problem.firstRow() + problem.lag.samples;
    const std::ptrdiff_t end = problem.endRow() + problem.lag.samples;
    for (std::ptrdiff_t n = 0; n < end; ++n) {
        if (n >= begin) {
            const std::ptrdiff_t index = n - problem.lag.samples;
            const Eigen::Vector4d at = recursion.within(state, n);
            // d x / d ln K = -K w etc. The cascade starts from w = 0, which leaves out free responses of its
            // own when x0 or v0 is not zero; the columns of x0 and v0 span exactly those.
            const double byStiffness = -dynamics.stiffness * at(2) / squaredSpeed;
            const double byDamping = -dynamics.damping * at(3) / dynamics.speed;
            if (problem.freeInitialState)
                row.head<2>() = free.position();
            if (problem.freeOffset)
                row(nuisances - 1) = 1;
            row(nuisances) = -at(0) - byDamping - byStiffness;
            row(nuisances + 1) = byDamping;
            row(nuisances + 2) = byStiffness;
            row(nuisances + 3) = problem.position[static_cast<std::size_t>(index)] - at(0) - nuisance.offset;
            use(index, row);
        }
        recursion.advance(state, n);
        free.advance();
    }
}

Linearization linearize(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                        const ScaledNuisance& nuisance)
{
    Linearization out;
    const int nuisances = problem.nuisanceCount();
    TallQr qr(nuisances + 4);
    forEachLinearizedRow(problem, theta, nuisance,
                         [&](std::ptrdiff_t, const Eigen::RowVectorXd& row) { qr.nextRow() = row; });
    const Eigen::MatrixXd triangle = qr.triangle();
    if (!triangle.allFinite())
        return out;
    const NuisanceProjection projection(triangle, nuisances);
    out.sensitivities = projection.rest.leftCols(3);
    out.residual = projection.rest.col(3);
    out.finite = true;
    return out;
}

} // namespace gripscope
