// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/exact_step.h"
#include "core/identification/output_error/output_error_problem.h"

#include <Eigen/Core>

#include <cmath>

namespace gripscope {

/// M, B, K as the matrices need them. Velocities are counted in units of `speed`, the natural frequency where
/// that is above one radian a sample, so that the matrices stay balanced.
struct CascadeDynamics {
    double stiffness, damping, compliance, speed;

    explicit CascadeDynamics(const Eigen::Vector3d& theta)
        : stiffness(std::exp(theta(2) - theta(0))), damping(std::exp(theta(1) - theta(0))),
          compliance(std::exp(-theta(0))), speed(std::max(1.0, std::sqrt(stiffness)))
    {
    }
    [[nodiscard]] bool finite() const
    {
        return std::isfinite(stiffness) && std::isfinite(damping) && std::isfinite(compliance) &&
               compliance > 0;
    }
};

/// x, x'/speed, w speed^2, w' speed, where w'' + (B/M) w' + (K/M) w = x: the position and, through w, its
/// derivatives by M, B and K.
struct CascadeState {
    double x = 0, v = 0, w = 0, u = 0;
};

/// The exact step of the cascade over a sample or the share `part` of it, as scalars: in the recursion over
/// the samples every product counts.
struct CascadeStep {
    double a00 = 1, a01 = 0, a10 = 0, a11 = 1; ///< of (x, v), and of (w, u)
    double c00 = 0, c01 = 0, c10 = 0, c11 = 0; ///< of (x, v) on (w, u)
    CascadeState held, rising;                 ///< of the force now and of the next force

    CascadeStep() = default;
    CascadeStep(const CascadeDynamics& dynamics, double part, ForceHold hold);

    [[nodiscard]] CascadeState operator()(const CascadeState& s, double now, double next) const
    {
        return {a00 * s.x + a01 * s.v + (held.x * now + rising.x * next),
                a10 * s.x + a11 * s.v + (held.v * now + rising.v * next),
                a00 * s.w + a01 * s.u + (c00 * s.x + c01 * s.v) + (held.w * now + rising.w * next),
                a10 * s.w + a11 * s.u + (c10 * s.x + c11 * s.v) + (held.u * now + rising.u * next)};
    }
};

/// One row of the linearised problem: its position's index, the response and its derivatives by ln M, ln B
/// and ln K for the start given.
struct CascadeRow {
    double response, byMass, byDamping, byStiffness;
};

/// Walks the cascade through the record, sample by sample, and shows it at the times of the positions.
class CascadeWalk {
public:
    CascadeWalk(const OutputErrorProblem& problem, const std::vector<double>& force,
                const CascadeDynamics& dynamics);

    void startAt(double x0, double v0) { m_state = {x0, v0 / m_speed, 0, 0}; }
    /// The row of the position at the present time (plus the rest of the lag). The cascade starts from w = 0,
    /// which leaves out free responses of its own when x0 or v0 is not zero; the columns of x0 and v0 span
    /// exactly those.
    [[nodiscard]] CascadeRow row() const
    {
        const CascadeState at = m_rest == 0 ? m_state : within();
        const double byStiffness = m_byW * at.w;
        const double byDamping = m_byU * at.u;
        return {at.x, -at.x - byDamping - byStiffness, byDamping, byStiffness};
    }
    void advance()
    {
        m_state = m_step(m_state, m_now, m_next);
        ++m_time;
        m_now = m_next;
        m_next = forceAt(m_time + 1);
        if (m_time % checkEvery == 0)
            clearVanishing();
    }
    [[nodiscard]] std::ptrdiff_t time() const { return m_time; }
    [[nodiscard]] const CascadeStep& step() const { return m_step; }
    [[nodiscard]] const CascadeStep& part() const { return m_part; }

    /// Steps between two looks whether a state has decayed.
    static constexpr std::ptrdiff_t checkEvery = 32;

private:
    [[nodiscard]] double forceAt(std::ptrdiff_t n) const { return m_force[n < m_last ? n : m_last]; }
    [[nodiscard]] CascadeState within() const;
    void clearVanishing();

    const double* m_force;
    std::ptrdiff_t m_last;
    double m_rest, m_speed, m_byW, m_byU;
    CascadeStep m_step, m_part;
    CascadeState m_state;
    double m_now, m_next;
    std::ptrdiff_t m_time = 0;
};

/// What a unit of x0 and of v0 adds to the position: the first row of phi^n.
class FreeResponses {
public:
    FreeResponses(const CascadeWalk& walk, double speed)
        : m_step(walk.step()), m_part(walk.part()), m_perSpeed(1 / speed)
    {
    }
    void advance()
    {
        if (m_gone)
            return;
        m_fromX = moved(m_fromX);
        m_fromV = moved(m_fromV);
        if (++m_time % CascadeWalk::checkEvery == 0)
            clearVanishing();
    }
    /// d x / d x0 and d x / d v0.
    [[nodiscard]] double byPosition() const { return m_part.a00 * m_fromX.x + m_part.a01 * m_fromX.v; }
    [[nodiscard]] double bySpeed() const
    {
        return (m_part.a00 * m_fromV.x + m_part.a01 * m_fromV.v) * m_perSpeed;
    }

private:
    [[nodiscard]] CascadeState moved(const CascadeState& s) const
    {
        return {m_step.a00 * s.x + m_step.a01 * s.v, m_step.a10 * s.x + m_step.a11 * s.v, 0, 0};
    }
    void clearVanishing();

    CascadeStep m_step, m_part;
    double m_perSpeed;
    std::ptrdiff_t m_time = 0;
    CascadeState m_fromX{1, 0, 0, 0}, m_fromV{0, 1, 0, 0};
    bool m_gone = false;
};

} // namespace gripscope
