// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic/periodic_response.h"

#include "core/identification/model/exact_step.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

using Complex = PeriodicResponse::Complex;
using Pair = Eigen::Matrix<Complex, 2, 1>;
using Inverse = Eigen::Matrix<Complex, 2, 2>;

ExactStep<4> stepOver(const Eigen::Matrix4d& motion, double part, double speed, double compliance,
                      ForceHold hold)
{
    Eigen::Vector4d input = Eigen::Vector4d::Zero();
    input(1) = part / speed;
    ExactStep<4> step = exactStep<4>(motion * part, input, hold);
    step.gamma0 *= compliance;
    step.gamma1 *= compliance;
    return step;
}

/// (z I - phi)^-1
Inverse resolvent(Complex z, const Eigen::Matrix2d& phi)
{
    const Complex a = z - phi(0, 0);
    const Complex d = z - phi(1, 1);
    Inverse adjugate;
    adjugate << d, phi(0, 1), phi(1, 0), a;
    return adjugate / (a * d - phi(0, 1) * phi(1, 0));
}

} // namespace

/// The state is (x, x'/speed, w speed^2, w' speed) with w'' + (B/M) w' + (K/M) w = x: the cascade that gives
/// the derivatives, d x / d K = -w and so on (Ljung, System Identification, ch. 10). Speeds are counted in
/// natural frequencies where these are above one radian a sample, so that the matrices stay balanced.
struct PeriodicResponse::Private {
    double stiffness, damping, speed;
    double rest;
    ExactStep<4> step, part;
    bool finite = false;

    Private(const Eigen::Vector3d& theta, ForceHold hold, double restOfLag)
        : stiffness(std::exp(theta(2) - theta(0))), damping(std::exp(theta(1) - theta(0))),
          speed(std::max(1.0, std::sqrt(stiffness))), rest(restOfLag)
    {
        const double compliance = std::exp(-theta(0));
        // Steps beyond this are over after one sample; their exponential would only lose digits.
        constexpr double largest = 1e6;
        if (!std::isfinite(compliance) || !(compliance > 0) || !(stiffness < largest * largest) ||
            !(damping < largest) || !(stiffness > 0))
            return;
        Eigen::Matrix4d motion = Eigen::Matrix4d::Zero();
        Eigen::Matrix2d single;
        single << 0, speed, -stiffness / speed, -damping;
        motion.topLeftCorner<2, 2>() = single;
        motion.bottomRightCorner<2, 2>() = single;
        motion(3, 0) = speed;
        step = stepOver(motion, 1, speed, compliance, hold);
        part = stepOver(motion, rest, speed, compliance, hold);
        finite = step.phi.allFinite() && step.gamma0.allFinite() && step.gamma1.allFinite() &&
                 part.phi.allFinite() && part.gamma0.allFinite() && part.gamma1.allFinite();
    }
};

PeriodicResponse::PeriodicResponse(const Eigen::Vector3d& theta, ForceHold hold, double rest)
    : d(std::make_unique<Private>(theta, hold, rest))
{
}

PeriodicResponse::~PeriodicResponse() = default;

bool PeriodicResponse::finite() const
{
    return d->finite;
}

PeriodicResponse::Value PeriodicResponse::at(double radiansPerSample, Complex force,
                                             const Eigen::Vector2d& start) const
{
    const Complex z = std::polar(1.0, radiansPerSample);
    const Inverse inverse = resolvent(z, d->step.phi.topLeftCorner<2, 2>());
    Eigen::Matrix<Complex, 4, 1> input = (d->step.gamma0 + z * d->step.gamma1) * force;
    input.head<2>() += z * start;
    Eigen::Matrix<Complex, 4, 1> state;
    const Pair motion = inverse * input.head<2>();
    const Eigen::Matrix2d coupling = d->step.phi.bottomLeftCorner<2, 2>();
    state.head<2>() = motion;
    state.tail<2>() = inverse * (coupling * motion + input.tail<2>());
    if (d->rest > 0)
        state =
            (d->part.phi * state + (d->part.gamma0 + d->part.gamma1 * ((1 - d->rest) + d->rest * z)) * force)
                .eval();
    Value value;
    value.position = state(0);
    value.gradient(2) = -d->stiffness / (d->speed * d->speed) * state(2);
    value.gradient(1) = -d->damping / d->speed * state(3);
    value.gradient(0) = -state(0) - value.gradient(1) - value.gradient(2);
    return value;
}

Eigen::Matrix<Complex, 2, 1> PeriodicResponse::byStart(double radiansPerSample) const
{
    const Complex z = std::polar(1.0, radiansPerSample);
    const Inverse inverse = resolvent(z, d->step.phi.topLeftCorner<2, 2>());
    return z * (d->part.phi.topLeftCorner<1, 2>() * inverse).transpose();
}

} // namespace gripscope
