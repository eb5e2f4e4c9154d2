// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/decompositions.h"
#include "core/signal/recording/recording.h"

#include <Eigen/Core>

namespace gripscope {

/// s[t+1] = phi s[t] + gamma0 F[t] + gamma1 F[t+1], the exact answer of s' = A s + B F after one unit of
/// time.
template <int N>
struct ExactStep {
    Eigen::Matrix<double, N, N> phi = Eigen::Matrix<double, N, N>::Identity();
    Eigen::Matrix<double, N, 1> gamma0 = Eigen::Matrix<double, N, 1>::Zero();
    Eigen::Matrix<double, N, 1> gamma1 = Eigen::Matrix<double, N, 1>::Zero();
};

/// From one exponential of [[A, B, 0], [0, 0, 1], [0, 0, 0]] (Van Loan 1978): its last column is the answer
/// to a force that rises from 0 to 1, the column before it that to a force of 1. Time is in units of the
/// step.
template <int N>
[[nodiscard]] ExactStep<N> exactStep(const Eigen::Matrix<double, N, N>& a,
                                     const Eigen::Matrix<double, N, 1>& b, ForceHold hold)
{
    Eigen::Matrix<double, N + 2, N + 2> generator = Eigen::Matrix<double, N + 2, N + 2>::Zero();
    generator.template topLeftCorner<N, N>() = a;
    generator.template block<N, 1>(0, N) = b;
    generator(N, N + 1) = 1;
    const Eigen::Matrix<double, N + 2, N + 2> flow = matrixExponential(generator);
    ExactStep<N> step;
    step.phi = flow.template topLeftCorner<N, N>();
    step.gamma0 = flow.template block<N, 1>(0, N);
    if (hold == ForceHold::First) {
        step.gamma1 = flow.template block<N, 1>(0, N + 1);
        step.gamma0 -= step.gamma1;
    }
    return step;
}

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
