// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/exact_step.h"

#include <Eigen/Core>

namespace gripscope {

/// 1 / (s^2/stiffness + s damping/stiffness + 1) from rest, and its first two derivatives, for a signal known
/// at the samples and held as declared between them: exact, time in samples.
class SecondOrderFilter {
public:
    SecondOrderFilter() = default;
    SecondOrderFilter(double stiffness, double damping, ForceHold hold)
        : m_stiffness(stiffness), m_damping(damping)
    {
        Eigen::Matrix2d a;
        a << 0, 1, -stiffness, -damping;
        m_step = exactStep<2>(a, Eigen::Vector2d(0, stiffness), hold);
    }
    [[nodiscard]] double value() const { return m_state(0); }
    [[nodiscard]] double slope() const { return m_state(1); }
    [[nodiscard]] double curvature(double input) const
    {
        return m_stiffness * (input - m_state(0)) - m_damping * m_state(1);
    }
    void advance(double now, double next)
    {
        m_state = (m_step.phi * m_state + m_step.gamma0 * now + m_step.gamma1 * next).eval();
    }

private:
    double m_stiffness = 1, m_damping = 2;
    ExactStep<2> m_step;
    Eigen::Vector2d m_state = Eigen::Vector2d::Zero();
};

} // namespace gripscope
