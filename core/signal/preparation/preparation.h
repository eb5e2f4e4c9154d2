// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/signal/preparation/held_position.h"
#include "core/signal/recording/recording.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

struct PreparationOptions {
    std::optional<ForceHold> hold; ///< empty: the recording's, else first-order
    bool findContact = true;       ///< cut approach and release, excise contact loss
    bool resample = true;          ///< put jittered samples on a regular grid
    bool removeFrame = true;       ///< take the chain's frame compliance out of the position
    /// Share of lost samples above which the record is cut at its gaps.
    double largestLostShare = 0.25;
};

/// One thing that was done to a recording or noticed in it. Ids: unusable, contact, clock_drift,
/// force_noise, clock_jitter, clock_break, samples_lost, window_cut, contact_loss, saturation, quantization,
/// frame_compliance, opening, force_spikes, position_held.
struct PreparationStep {
    QString id;
    std::size_t count = 0; ///< samples or places it concerns
    double value = 0;      ///< its size: see the message
    bool ok = true;        ///< false: the estimate may suffer in spite of it
    Finding message;
};

/// The part of a recording that is to be identified. `lostSamples` counts the samples missing inside the
/// stretch asked for, `eligible` the samples it has.
struct WindowChoice {
    Window window;
    std::size_t eligible = 0;
    std::int64_t lostSamples = 0;
    std::size_t gaps = 0;
};

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

/// A recording ready for the estimators: force and position on a regular grid of known sample time.
struct PreparedRecord {
    double sampleTime_s = 0;
    std::vector<double> time_s, force, position;
    /// Sorted indexes at which nothing can be used; the values there are for plots only.
    std::vector<std::size_t> lost;
    std::optional<ForceHold> hold; ///< as the recording said
    double forceLag_s = 0;
    /// As the recording said; the frame's share is out of `position` already. A force noise that was not
    /// stated is that of the samples before the squeeze, where there are enough of them.
    MeasuringChain chain;
    double lagBound_s = 0;   ///< of a lag that nobody measured (unmeasuredLagBound_s()); 0: it is known
    double positionStep = 0; ///< of the lattice that the positions came on (latticeStep()); 0: none
    /// Where the position is renewed too slowly for any motion to be in it: the whole squeeze as it came.
    std::optional<HeldPosition> held;
    std::vector<PreparationStep> steps;

    /// The recording's samples from the first to the last used; `eligible` those there are in the squeeze,
    /// the losses and gaps those within it.
    WindowChoice choice;
    ContactPhases phases; ///< in the recording's own samples

    [[nodiscard]] const PreparationStep* find(const QString& id) const;
};

/// Its samples [first, first + count) alone, without times and steps; of the chain the gripper's own
/// friction.
[[nodiscard]] PreparedRecord windowOf(const PreparedRecord& record, Window window);

/// Takes a recording through, in this order: the samples the device calls the squeeze (StatusMoving), the
/// phases of contact (findContact), the noise of the force before them
/// (restingForceNoise), the clock and the lost samples (readSampleClock), where more than
/// `largestLostShare` are lost the best part between gaps, the regular grid (placeOnGrid, or resampleToGrid
/// for a jittered clock), contact loss, the frame's compliance; and looks for saturation and quantisation.
///
/// A position that falls as the force rises, in a record with an approach, is the opening between the
/// fingers: it comes out with its sign turned. Where the position is held (heldPosition()) the squeeze is the
/// whole contact, and neither contact loss nor saturation of the position is looked for.
///
/// A record to which none of this applies comes out bit for bit as it went in, with no steps. Data that can't
/// be used (channels of different length, numbers that are not finite, no sample time) comes out as it is
/// with the step "unusable". Pure; O(N log N).
[[nodiscard]] PreparedRecord prepare(const Recording& recording, const PreparationOptions& options = {});

} // namespace gripscope
