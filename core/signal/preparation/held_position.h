// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// A squeeze whose position is renewed far more slowly than its rows come: a slow gripper's width beside a
/// force of another clock. Between two renewals the rows repeat what was measured before, so that the
/// position at any moment lies between the value that stands and the next one, as far as it moves one way.
struct HeldPosition {
    double interval_s = 0;    ///< for which a value stands until the next one comes, the median
    double clockOffset_s = 0; ///< what the position shows at t + clockOffset_s belongs to the force at t
    double clockBound_s = 0;  ///< give or take so much
    bool opening = false;     ///< the position fell as the force rose, as the opening between fingers does
    Window contact;           ///< from the touch to the release, in the vectors below
    std::size_t spikes = 0;   ///< samples outside of contact whose force is beyond the contact's threshold
    double largestSpike = 0;  ///< of their forces, with its sign as recorded; the force's unit
    double forceNoise = 0;    ///< standard deviation, the force's unit
    /// The squeeze with all that was recorded before and behind it, pushing and closing being positive. Units
    /// of the channels, which are named for sentences; times in s.
    std::vector<double> time_s, force, position;
    QString forceUnit, positionUnit;
};

/// How far the clocks of two channels may be apart about which nothing is stated, in renewals of the slow
/// one: one that a value takes from the sensor until it is sent, one that it waits for a row, and one for the
/// filter and the way of the force. (The value's age between two renewals is counted apart.)
inline constexpr double clockBoundInRenewals = 3;

/// Finds a held position in a record that has an approach; nothing for any other record, and wherever it is
/// not plain. Pure; O(N log N). All three equally long and finite, times increasing.
///
/// Contact is the unbroken stretch, of either sign, with the force above 5 % of its largest of that sign,
/// that has the largest sum of sqrt|F|: a spike, however high, is short. It begins five samples into the
/// record at least, with the position elsewhere. Up to the largest force
/// - the position stands still for three rows and more, five times at least, and comes there from where it
///   stood before by 1 % of its range and by twenty steps of its lattice (latticeStep()): a converter's steps
///   are one of these;
/// - of the rows from the first such stand to the last, two in five belong to them;
/// - in contact, a tenth of the largest force comes while the position stands, and more than six standard
///   deviations of its noise explain: the force of a gripper that moves in steps stands with it.
[[nodiscard]] std::optional<HeldPosition>
heldPosition(std::span<const double> time_s, std::span<const double> force, std::span<const double> position);

} // namespace gripscope
