// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace gripscope {

/// m, b, k of the empty gripper, which move in parallel with the object's, in the channels' units.
struct GripperBaseline {
    std::array<double, 3> parameters{};     ///< m, b, k
    std::array<double, 3> standardErrors{}; ///< of m, b, k
    friend bool operator==(const GripperBaseline&, const GripperBaseline&) = default;
};

/// Coulomb friction of the empty gripper itself, which adds to the object's: the force unit.
struct GripperFriction {
    double value = 0;
    double standardError = 0; ///< above zero
    friend bool operator==(const GripperFriction&, const GripperFriction&) = default;
};

/// What is known of the device that measured: systematic effects with their standard uncertainties (GUM, JCGM
/// 100). A zero means: known exactly, or not there.
struct MeasuringChain {
    double forceLagUncertainty_s = 0; ///< of Recording::forceLag_s
    double forceNoiseDeviation = 0;   ///< standard deviation of white noise on the force channel, force unit
    double forceScaleUncertainty = 0; ///< relative, of the force channel's calibration
    double positionScaleUncertainty = 0;   ///< relative, of the position channel's calibration
    double frameCompliance = 0;            ///< of frame and fingers in series, position unit per force unit
    double frameComplianceUncertainty = 0; ///< same unit
    std::optional<GripperBaseline> baseline;
    std::optional<GripperFriction> friction; ///< absent: nobody measured it

    friend bool operator==(const MeasuringChain&, const MeasuringChain&) = default;
};

} // namespace gripscope
