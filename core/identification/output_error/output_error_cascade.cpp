// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error_cascade.h"

namespace gripscope {

namespace {

/// Far below anything that counts beside positions of about 1, far above denormal numbers and their squares.
constexpr double vanishingState = 1e-150;

CascadeState scaled(const Eigen::Vector4d& gamma, double factor)
{
    return {gamma(0) * factor, gamma(1) * factor, gamma(2) * factor, gamma(3) * factor};
}

} // namespace

CascadeStep::CascadeStep(const CascadeDynamics& dynamics, double part, ForceHold hold)
{
    Eigen::Matrix2d motion;
    motion << 0, dynamics.speed, -dynamics.stiffness / dynamics.speed, -dynamics.damping;
    Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
    a.topLeftCorner<2, 2>() = motion;
    a.bottomRightCorner<2, 2>() = motion;
    a(3, 0) = dynamics.speed;
    const Eigen::Vector4d b(0, part / dynamics.speed, 0, 0);
    const ExactStep<4> step = exactStep<4>(a * part, b, hold);
    a00 = step.phi(0, 0);
    a01 = step.phi(0, 1);
    a10 = step.phi(1, 0);
    a11 = step.phi(1, 1);
    c00 = step.phi(2, 0);
    c01 = step.phi(2, 1);
    c10 = step.phi(3, 0);
    c11 = step.phi(3, 1);
    // A force of size 1 / M.
    held = scaled(step.gamma0, dynamics.compliance);
    rising = scaled(step.gamma1, dynamics.compliance);
}

CascadeWalk::CascadeWalk(const OutputErrorProblem& problem, const std::vector<double>& force,
                         const CascadeDynamics& dynamics)
    : m_force(force.data()), m_last(static_cast<std::ptrdiff_t>(force.size()) - 1), m_rest(problem.lag.rest),
      m_speed(dynamics.speed), m_byW(-dynamics.stiffness / (dynamics.speed * dynamics.speed)),
      m_byU(-dynamics.damping / dynamics.speed), m_step(dynamics, 1, problem.hold), m_now(forceAt(0)),
      m_next(forceAt(1))
{
    if (m_rest > 0)
        m_part = CascadeStep(dynamics, m_rest, problem.hold);
}

CascadeState CascadeWalk::within() const
{
    // A straight force reaches only the share `rest` of its way.
    return m_part(m_state, m_now, (1 - m_rest) * m_now + m_rest * m_next);
}

void CascadeWalk::clearVanishing()
{
    // Without force it decays; zero is faster than the denormal numbers it would end in.
    const double largest =
        std::max({std::abs(m_state.x), std::abs(m_state.v), std::abs(m_state.w), std::abs(m_state.u)});
    if (largest < vanishingState)
        m_state = {};
}

void FreeResponses::clearVanishing()
{
    const double largest =
        std::max({std::abs(m_fromX.x), std::abs(m_fromX.v), std::abs(m_fromV.x), std::abs(m_fromV.v)});
    if (largest >= vanishingState)
        return;
    m_fromX = m_fromV = {};
    m_gone = true;
}

} // namespace gripscope
