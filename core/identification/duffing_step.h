// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>

namespace gripscope {

/// Coefficients of one step of M x'' + B x' + K x = F + g, g = -K3 x^3 the force of the cubic spring, for a
/// force that runs straight from Fa to Fb within the step. The state is (x, v), v = x' / speed.
///
/// The linear spring is integrated exactly; g is taken for the parabola through its values at the beginning,
/// the middle and the end of the step, found by a constant g for the middle and by the middle's g for the
/// end:
///     xh = half . (x, v) + halfForce . (Fa, Fb) + halfSpring g(x)
///     xe = [phi (x, v) + forceStart Fa + forceEnd Fb]_x + predictSpring g(xh)
///     (x, v) <- phi (x, v) + forceStart Fa + forceEnd Fb + springStart g(x) + springHalf g(xh) + springEnd
///     g(xe)
/// With K = B = 0 that is Nystroem's method of order 4 (1925); with them it is its exponential form
/// (Hochbruck and Ostermann, Exponential integrators, 2010): order 4, exact for K3 = 0 at any step and any
/// damping.
struct DuffingStep {
    Eigen::RowVector2d half, halfForce;
    double halfSpring = 0, predictSpring = 0;
    Eigen::Matrix2d phi;
    Eigen::Vector2d forceStart, forceEnd, springStart, springHalf, springEnd;
};

/// A step and its exact derivatives by ln M, ln B and ln K.
struct DuffingStepFamily {
    DuffingStep value;
    std::array<DuffingStep, 3> derivatives;
};

/// Over `length` units of time, theta = (ln M, ln B, ln K); from matrix exponentials (Van Loan 1978), their
/// derivatives from those of block triangular matrices (Najfeld and Havel 1995). K / M and B / M times the
/// unit of time must be finite.
[[nodiscard]] DuffingStepFamily duffingStep(const Eigen::Vector3d& theta, double speed, double length);

} // namespace gripscope
