// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing_step.h"

#include "core/identification/matrix_exponential.h"

#include <cmath>

namespace gripscope {

namespace {

/// What the linear spring answers to a start and to the forces 1, tau and tau^2 / 2, tau from 0 to 1.
struct Responses {
    Eigen::Matrix2d phi;
    Eigen::Vector2d constant, ramp, parabola;
};
struct ResponseFamily {
    Responses value;
    std::array<Responses, 3> derivatives;
};

using Generator = Eigen::Matrix<double, 5, 5>;

Responses responsesIn(const Eigen::MatrixXd& flow, double compliance)
{
    return {flow.topLeftCorner<2, 2>(), compliance * flow.block<2, 1>(0, 2),
            compliance * flow.block<2, 1>(0, 3), compliance * flow.block<2, 1>(0, 4)};
}

/// exp(generator) in the upper left, its derivative in the direction given in the upper right.
Eigen::MatrixXd flowAndDerivative(const Generator& generator, const Generator& direction)
{
    Eigen::MatrixXd pair = Eigen::MatrixXd::Zero(10, 10);
    pair.topLeftCorner<5, 5>() = generator;
    pair.bottomRightCorner<5, 5>() = generator;
    pair.topRightCorner<5, 5>() = direction;
    return matrixExponential(pair);
}

/// By ln M: the matrix depends on B / M and K / M alone, the size of the force on 1 / M.
Responses byMass(const Responses& value, const Responses& byDamping, const Responses& byStiffness)
{
    return {-byDamping.phi - byStiffness.phi, -value.constant - byDamping.constant - byStiffness.constant,
            -value.ramp - byDamping.ramp - byStiffness.ramp,
            -value.parabola - byDamping.parabola - byStiffness.parabola};
}

ResponseFamily responsesOver(const Eigen::Vector3d& theta, double speed, double length)
{
    const double stiffness = std::exp(theta(2) - theta(0));
    const double damping = std::exp(theta(1) - theta(0));
    const double compliance = std::exp(-theta(0));
    Generator byDamping = Generator::Zero();
    byDamping(1, 1) = -damping * length;
    Generator byStiffness = Generator::Zero();
    byStiffness(1, 0) = -stiffness * length / speed;
    Generator generator = byDamping + byStiffness;
    generator(0, 1) = speed * length;
    generator(1, 2) = length / speed;
    generator(2, 3) = 1;
    generator(3, 4) = 1;
    const Eigen::MatrixXd damped = flowAndDerivative(generator, byDamping);
    const Eigen::MatrixXd stiff = flowAndDerivative(generator, byStiffness);
    ResponseFamily family;
    family.value = responsesIn(damped.topLeftCorner<5, 5>(), compliance);
    family.derivatives[1] = responsesIn(damped.topRightCorner<5, 5>(), compliance);
    family.derivatives[2] = responsesIn(stiff.topRightCorner<5, 5>(), compliance);
    family.derivatives[0] = byMass(family.value, family.derivatives[1], family.derivatives[2]);
    return family;
}

/// Linear in the responses, so that it serves the derivatives as well.
DuffingStep compose(const Responses& half, const Responses& whole)
{
    DuffingStep step;
    step.half = half.phi.row(0);
    step.halfForce = {half.constant(0) - half.ramp(0) / 2, half.ramp(0) / 2};
    step.halfSpring = half.constant(0);
    step.predictSpring = whole.constant(0);
    step.phi = whole.phi;
    step.forceStart = whole.constant - whole.ramp;
    step.forceEnd = whole.ramp;
    step.springStart = whole.constant - 3 * whole.ramp + 4 * whole.parabola;
    step.springHalf = 4 * whole.ramp - 8 * whole.parabola;
    step.springEnd = 4 * whole.parabola - whole.ramp;
    return step;
}

} // namespace

DuffingStepFamily duffingStep(const Eigen::Vector3d& theta, double speed, double length)
{
    const ResponseFamily half = responsesOver(theta, speed, length / 2);
    const ResponseFamily whole = responsesOver(theta, speed, length);
    DuffingStepFamily family;
    family.value = compose(half.value, whole.value);
    for (std::size_t i = 0; i < 3; ++i)
        family.derivatives[i] = compose(half.derivatives[i], whole.derivatives[i]);
    return family;
}

} // namespace gripscope
