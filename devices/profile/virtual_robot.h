// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/discretization.h"
#include "devices/virtual/random_stream.h"
#include "devices/virtual/virtual_object.h"

#include <vector>

namespace gripscope {

struct VirtualRobotOptions {
    VirtualObject object;
    std::uint64_t seed = 1;
    double sampleTime_s = 0.001;
    ForceHold hold = ForceHold::Zero;
    double positionNoise_m = 5e-6; ///< both noises as the virtual gripper's
    double forceNoise_N = 0.02;
};

/// A robot that squeezes the same object again and again by a program of its own, sample for sample: a
/// second at rest, two seconds of pseudo-random force between 10 and 30 N, and so on.
///
/// The object is m x'' + b x' + k x = F, stepped exactly for the force's hold; it is
/// `object.draw(seed, 0)`, the same one every time, since nobody puts another into the fingers.
class VirtualRobot {
public:
    static constexpr double rest_s = 1;
    static constexpr double squeeze_s = 2;
    static constexpr double bias_N = 20;
    static constexpr double peak_N = 10;
    static constexpr double contact_m = 0.012347; ///< where the fingers touch the object
    static constexpr double range_m = 0.05;

    struct Reading {
        double force_N = 0, position_m = 0;
        bool moving = false;
    };

    explicit VirtualRobot(const VirtualRobotOptions& options);
    /// The next sample. One that starts a squeeze works out its force first.
    [[nodiscard]] Reading next();

private:
    [[nodiscard]] double plannedForce(std::uint64_t sample) const;
    void planSqueeze(std::uint64_t number);

    VirtualRobotOptions m_options;
    Discretization m_step;
    Eigen::Vector2d m_state = Eigen::Vector2d::Zero(); ///< position from the contact point and speed, SI
    RandomStream m_noise;
    std::uint64_t m_sample = 0;
    std::uint64_t m_restSamples, m_squeezeSamples;
    std::vector<double> m_squeeze_N; ///< that of the cycle under way
};

} // namespace gripscope
