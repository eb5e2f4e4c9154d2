// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/arx/arx.h"

#include <cmath>

namespace gripscope {

namespace {

bool physical(const MassDampingStiffness& p)
{
    const auto good = [](double value) { return value > 0 && std::isfinite(value); };
    return good(p.m) && good(p.b) && good(p.k);
}

/// wn^2 T^2 = (sT)^2 + q, where q is the square of the angle whose cosine is c: acos(c)^2 or -acosh(c)^2.
struct SquaredAngle {
    double value = 0; ///< q
    double slope = 0; ///< dq/dc, which is smooth through c = 1, where q = 0 and dq/dc = -2
};

SquaredAngle squaredAngle(double c)
{
    const double gap = 1 - c;
    // Near c = 1: acos(c)^2 = 2 d + d^2/3 + 4 d^3/45 + ..., d = 1 - c, on both sides.
    if (std::abs(gap) < 1e-4) {
        const double value = gap * (2 + gap * (1.0 / 3 + gap * 4 / 45));
        return {value, -(2 + gap * (2.0 / 3 + gap * 12 / 45))};
    }
    if (gap > 0) {
        const double angle = std::acos(c);
        return {angle * angle, -2 * angle / std::sqrt(gap * (1 + c))};
    }
    const double angle = std::acosh(c);
    return {-angle * angle, -2 * angle / std::sqrt(-gap * (1 + c))};
}

} // namespace

std::optional<MassDampingStiffness> centralDifferenceMapping(double a1, double a2, double b1,
                                                             double sampleTime_s)
{
    if (!(b1 > 0) || !(std::abs(a2) < 1) || !(1 + a1 + a2 > 0))
        return std::nullopt;
    const MassDampingStiffness p{sampleTime_s * sampleTime_s * (1 + a2) / (2 * b1),
                                 sampleTime_s * (1 - a2) / b1, (1 + a1 + a2) / b1};
    return physical(p) ? std::optional(p) : std::nullopt;
}

Eigen::Matrix3d centralDifferenceJacobian(double a1, double a2, double b1, double sampleTime_s)
{
    const double t = sampleTime_s;
    Eigen::Matrix3d jacobian;
    jacobian << 0, t * t / (2 * b1), -t * t * (1 + a2) / (2 * b1 * b1), //
        0, -t / b1, -t * (1 - a2) / (b1 * b1),                          //
        1 / b1, 1 / b1, -(1 + a1 + a2) / (b1 * b1);
    return jacobian;
}

std::optional<MassDampingStiffness> poleMapping(double a1, double a2, double numeratorSum,
                                                double sampleTime_s)
{
    if (!(a2 > 0) || !(a2 < 1) || !(1 + a1 + a2 > 0) || !(numeratorSum > 0))
        return std::nullopt;
    const double c = -a1 / (2 * std::sqrt(a2));
    if (!(c > -1)) // poles on the negative axis belong to no continuous system
        return std::nullopt;
    const double decay = -std::log(a2) / 2;
    const double squaredFrequency = decay * decay + squaredAngle(c).value;
    if (!(squaredFrequency > 0))
        return std::nullopt;
    MassDampingStiffness p;
    p.k = (1 + a1 + a2) / numeratorSum;
    p.m = p.k / squaredFrequency * sampleTime_s * sampleTime_s;
    p.b = 2 * decay / sampleTime_s * p.m;
    return physical(p) ? std::optional(p) : std::nullopt;
}

Eigen::Matrix3d poleJacobian(double a1, double a2, double numeratorSum, double sampleTime_s)
{
    const double c = -a1 / (2 * std::sqrt(a2));
    const SquaredAngle angle = squaredAngle(c);
    const double decay = -std::log(a2) / 2;
    const double squaredFrequency = decay * decay + angle.value;
    const Eigen::RowVector3d byCosine(-1 / (2 * std::sqrt(a2)), -c / (2 * a2), 0);
    const Eigen::RowVector3d byDecay(0, -1 / (2 * a2), 0);
    const Eigen::RowVector3d bySquaredFrequency = 2 * decay * byDecay + angle.slope * byCosine;

    const double k = (1 + a1 + a2) / numeratorSum;
    const double m = k / squaredFrequency * sampleTime_s * sampleTime_s;
    const Eigen::RowVector3d byK(1 / numeratorSum, 1 / numeratorSum, -k / numeratorSum);
    const Eigen::RowVector3d byM = m * (byK / k - bySquaredFrequency / squaredFrequency);
    Eigen::Matrix3d jacobian;
    jacobian.row(0) = byM;
    jacobian.row(1) = 2 / sampleTime_s * (byDecay * m + decay * byM);
    jacobian.row(2) = byK;
    return jacobian;
}

} // namespace gripscope
