// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/recursive/recursive_pass.h"

#include "core/identification/model/exact_step.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// A column of which the columns before it explain all but this share (squared) adds nothing but rounding.
constexpr double explainedShare = 1e-13;

} // namespace

RecursivePass::RecursivePass(const Point& point, ForceHold hold, double rest) : m_point(point)
{
    const double stiffness = std::exp(point.theta(2) - point.theta(0));
    const double damping = std::exp(point.theta(1) - point.theta(0));
    const double compliance = std::exp(-point.theta(0));
    const double speed = std::max(1.0, std::sqrt(stiffness));
    // Above these the matrix exponential itself runs out of digits.
    constexpr double fastest = 1e4;
    if (!point.nuisance.allFinite() || !std::isfinite(compliance) || !(compliance > 0) ||
        !(speed < fastest) || !(damping < fastest))
        return;
    Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
    a(0, 1) = a(2, 3) = speed;
    a(1, 0) = a(3, 2) = -stiffness / speed;
    a(1, 1) = a(3, 3) = -damping;
    a(3, 0) = speed;
    // From one position's time to the next: to the force's sample in between, and on.
    const auto over = [&](double part) {
        return exactStep<4>(a * part, Eigen::Vector4d(0, part / speed, 0, 0), hold);
    };
    const ExactStep<4> first = over(1 - rest);
    if (rest > 0) {
        const ExactStep<4> second = over(rest);
        m_phi = second.phi * first.phi;
        m_byForce.col(0) = second.phi * first.gamma0;
        m_byForce.col(1) = second.phi * first.gamma1 + second.gamma0;
        if (hold == ForceHold::First) { // the parts begin and end between two samples
            m_byForce.col(1) += rest * m_byForce.col(0) + (1 - rest) * second.gamma1;
            m_byForce.col(0) *= 1 - rest;
            m_byForce.col(2) = rest * second.gamma1;
        }
    } else {
        m_phi = first.phi;
        m_byForce.col(0) = first.gamma0;
        m_byForce.col(1) = first.gamma1;
    }
    m_byForce *= compliance;
    m_stiffnessFactor = -stiffness / (speed * speed);
    m_dampingFactor = -damping / speed;
    m_velocityFactor = 1 / speed;
    m_state << point.nuisance(0), point.nuisance(1) / speed, 0, 0;
    m_usable = m_phi.allFinite() && m_byForce.allFinite();
}

RecursivePass::Solution RecursivePass::solve(double damping) const
{
    // L D L' (Cholesky without roots, which no scaling of the columns changes), nuisances first, the
    // right-hand side carried along as a last row; a dependent nuisance is left out.
    constexpr int n = 6;
    double l[n + 1][n + 1];
    double diagonal[n];
    l[0][0] = m_freeProducts[0][0];
    l[1][0] = m_freeProducts[0][1];
    l[1][1] = m_freeProducts[1][1];
    for (std::size_t i = 0, at = 0; i < columns; ++i) {
        l[i + 2][0] = m_crossProducts[0][i];
        l[i + 2][1] = m_crossProducts[1][i];
        for (std::size_t j = 0; j <= i; ++j)
            l[i + 2][j + 2] = m_products[at++];
    }
    for (int i = 0; i < n; ++i)
        diagonal[i] = l[i][i];
    for (int i = 3; i < n; ++i)
        l[i][i] *= 1 + damping;
    Solution solution;
    double inversePivot[n];
    for (int j = 0; j < n; ++j) {
        if (j == 3)
            solution.cost = std::max(l[n][n], 0.0);
        const bool counts = l[j][j] > explainedShare * diagonal[j];
        if (!counts && j >= 3)
            return solution;
        inversePivot[j] = counts ? 1 / l[j][j] : 0;
        for (int i = j + 1; i <= n; ++i) {
            const double factor = l[i][j] * inversePivot[j];
            for (int c = j + 1; c <= i; ++c)
                l[i][c] -= factor * l[c][j];
        }
    }
    solution.costAtStep = std::max(l[n][n], 0.0);
    // Back: l[i][j] is L(i,j) D(j).
    double step[n];
    for (int j = n - 1; j >= 0; --j) {
        double value = l[n][j];
        for (int i = j + 1; i < n; ++i)
            value -= l[i][j] * step[i];
        step[j] = value * inversePivot[j];
    }
    // The inverse of the 3 x 3 block that is left of the parameters: (L D L')^-1 with unit triangle L.
    const double l10 = l[4][3] * inversePivot[3], l20 = l[5][3] * inversePivot[3],
                 l21 = l[5][4] * inversePivot[4];
    const double k20 = l10 * l21 - l20;
    Eigen::Matrix3d inverse;
    inverse(2, 2) = inversePivot[5];
    inverse(1, 2) = -l21 * inversePivot[5];
    inverse(0, 2) = k20 * inversePivot[5];
    inverse(1, 1) = inversePivot[4] - l21 * inverse(1, 2);
    inverse(0, 1) = -l10 * inversePivot[4] - l21 * inverse(0, 2);
    inverse(0, 0) = inversePivot[3] - l10 * (-l10 * inversePivot[4]) + k20 * inverse(0, 2);
    inverse(1, 0) = inverse(0, 1);
    inverse(2, 0) = inverse(0, 2);
    inverse(2, 1) = inverse(1, 2);
    solution.nuisanceStep = Eigen::Vector3d(step[0], step[1], step[2]);
    solution.step = Eigen::Vector3d(step[3], step[4], step[5]);
    solution.inverse = inverse;
    solution.determined = solution.step.allFinite() && solution.nuisanceStep.allFinite() &&
                          solution.inverse.allFinite() && std::isfinite(solution.cost);
    return solution;
}

} // namespace gripscope
