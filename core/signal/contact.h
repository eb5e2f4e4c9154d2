// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

#include <cstddef>
#include <span>

namespace gripscope {

/// The phases of a squeeze, as indexes of samples:
///     approach [0, touch)      the gripper closes on nothing, the force rests at zero
///     touch    [touch, loaded) the force rises to its working range
///     settle   [loaded, squeeze.first)   bounces until it stays there
///     squeeze                            what is to be identified
///     release  [end of squeeze, N)       the force falls to zero and the gripper opens
/// A record that begins or ends in contact has no approach, touch and settle, or no release.
struct ContactPhases {
    bool hasApproach = false, hasRelease = false;
    std::size_t touch = 0, loaded = 0;
    Window squeeze;
    friend bool operator==(const ContactPhases&, const ContactPhases&) = default;
};

/// Finds the phases from force and position alone, whatever their units and signs.
///
/// An approach is a start at rest force (within 5 % of zero and its noise, five samples at least) during
/// which the gripper moves towards the place of the touch: by more than ten times the noise and either a
/// tenth of the squeeze's range, all positions under load lying beyond the touch, or from as far off the
/// nearest of them as that range. A release is the same with time reversed. A force that pulls as well as
/// pushes has no such rest. A start at rest that does not move may be contact without force, and is kept: it
/// follows the model m x'' + b x' + k x = F, which motion in the air does not.
///
/// The squeeze is cut to where the force has come up to a quarter of its swing below the smallest force of
/// the middle half for good. Noise is estimated from the record (whiteNoiseDeviation()), so that no limit
/// depends on scale. Both channels equally long; without phases the squeeze is everything.
[[nodiscard]] ContactPhases findContact(std::span<const double> force, std::span<const double> position);

} // namespace gripscope
