// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/preparation/preparation.h"
#include "core/signal/preparation/sample_clock.h"
#include "core/signal/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// Picks the part of a recording that is to be identified: where the device reports that the excitation is
/// moving (StatusMoving) the longest unbroken stretch of those samples, else the longest unbroken stretch of
/// all.
[[nodiscard]] WindowChoice chooseWindow(const Recording& recording);

/// The longest run of samples that all report the excitation moving, gaps or not, the first of equals;
/// without any such sample, everything.
[[nodiscard]] Window movingWindow(const Recording& recording);

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

/// The same where the position is the opening between the fingers: with its sign turned an approach is found,
/// and in contact force and position as they are go against each other (their covariance is below zero).
/// Nothing for any other record. To be asked where findContact() finds neither approach nor release.
[[nodiscard]] std::optional<ContactPhases> findOpening(std::span<const double> force,
                                                       std::span<const double> position);

/// The samples at which a gripper that can only push had left the object: an object can't be pulled, so that
/// while the command would pull, the force rests at zero and the gripper moves on its own. Such a run has
/// three samples at rest or more, and in it the position leaves the squeeze's range (99 % of the positions
/// under load) by as much again and six times its noise; one sample on either side goes with it. A free swing
/// in contact hardly ever goes that far, however weak the damping, so that runs which stay nearer are kept as
/// contact without force. Sorted; empty for a force that
/// also pulls. The channels are equally long and hold the squeeze only.
[[nodiscard]] std::vector<std::size_t> findContactLoss(std::span<const double> force,
                                                       std::span<const double> position);

/// Force and position on a regular grid of samples 0 .. N-1; at the indexes in `lost` (sorted) nothing was
/// measured, and the values there are a straight line between the neighbours, for plots only.
struct GriddedChannels {
    std::vector<double> force, position;
    std::vector<std::size_t> lost;
};

/// Puts each sample at its index, unchanged. `index` increases strictly; the grid goes from its first to its
/// last value, which the caller has found to be a size that fits. All three equally long.
[[nodiscard]] GriddedChannels placeOnGrid(std::span<const double> force, std::span<const double> position,
                                          std::span<const std::int64_t> index);

/// The same for samples taken off the grid, `time` in sample times (the grid's point n is at index[0] + n):
///
/// - Force: the function of time that the device's samples stand for (straight lines between them for a
///   first-order hold, steps for a zero-order one) is projected orthogonally on the functions that the grid
///   can hold (de Boor, A Practical Guide to Splines, ch. 14; for steps: the mean over each sample time). The
///   impulse over each sample time, and for straight lines its first moment too, is kept, so that an object
///   answers the same up to (omega T)^2 times the jitter. Measured against the exact response of can A to a
///   binary force with 10 % jitter: m within 0.02 % (first-order) and 0.07 % (zero-order) at omega T = 0.3,
///   where taking the samples as regular is off by 2.4 and 4 %.
/// - Position, which is smooth: the cubic through the four samples around (Lagrange). Its error at a distance
///   d from a sample is x'''' d T^3 / 12, for jumps of the acceleration a d T / 4 at the most.
///
/// Both act on each unbroken stretch alone as far as the force is concerned, so that nothing unknown leaks
/// into what was measured. A grid point counts as measured when it lies within a stretch or at most 0.3
/// sample times outside. A jitter above 0.2 is too large: points are lost, and neighbours change places.
[[nodiscard]] GriddedChannels resampleToGrid(std::span<const double> force, std::span<const double> position,
                                             std::span<const std::int64_t> index,
                                             std::span<const double> time, ForceHold hold);

/// The force values at the grid points firstPoint .. firstPoint + count - 1 (one sample time apart) whose
/// held function is nearest, in the sense of least squares over time, to the held function of the samples
/// `force` at `time` (in sample times, increasing, no gaps).
///   First-order hold: straight lines on both sides; a tridiagonal system of the hat functions' products
///   (diagonal 2/3, sides 1/6), the end segments continued beyond the first and last sample.
///   Zero-order hold: the mean over each sample time.
/// No samples: zeros. O(samples + count).
[[nodiscard]] std::vector<double> projectForce(std::span<const double> force, std::span<const double> time,
                                               std::int64_t firstPoint, std::size_t count, ForceHold hold);

/// The samples to keep so that at most `largestShare` of the grid they span is lost: all of them where that
/// holds; else the window with the largest measured - lost (1 - largestShare) / largestShare, which keeps as
/// many samples as it can and never exceeds the share (maximum-sum interval, Bentley 1984). `index` are the
/// samples' places on the grid, increasing; `largestShare` is above 0 and below 1. O(N).
[[nodiscard]] Window keepLostShare(std::span<const std::int64_t> index, double largestShare);

/// The least number of samples at rest that tell the noise of the force channel: a fifth of its deviation.
inline constexpr std::size_t leastRestingSamples = 20;

/// Standard deviation of white noise on a force channel while the gripper rests or closes on nothing: half
/// the mean square of the differences between neighbours, which a drift of the zero hardly enters (von
/// Neumann 1941). Relative standard error sqrt(3 / (4 N)). Nothing from fewer than leastRestingSamples, from
/// a force that does not rest (its variance more than twice that), or from one that stands still but for a
/// few steps of its converter (under half the differences other than zero).
[[nodiscard]] std::optional<double> restingForceNoise(std::span<const double> force);

/// The position of the object itself when frame and fingers yield in series with it:
///     x[n] = position[n] - compliance F(t_n + lag),
/// F(t_n + lag) read from the sampled force as it is held (the force's last value beyond its ends). Assumes
/// that frame and fingers yield at once: their own natural frequency is far above the object's. `compliance`
/// is measured on a rigid block, in position units per force unit (science: left out, k comes out too small
/// by compliance times k). `lag` is in samples. The vectors are equally long; numbers that do not give a
/// finite result leave the position as it is.
[[nodiscard]] std::vector<double> withoutFrame(const std::vector<double>& position,
                                               const std::vector<double>& force, double compliance,
                                               double lag = 0, ForceHold hold = ForceHold::First);

// What prepare() did and noticed, in numbers and words.

[[nodiscard]] PreparationStep unusableStep();
[[nodiscard]] PreparationStep contactStep(const ContactPhases& phases, Window asked);
[[nodiscard]] PreparationStep forceNoiseStep(std::size_t samples, double deviation, const QString& forceUnit);
[[nodiscard]] PreparationStep driftStep(const SampleClock& clock, double nominal_s);
[[nodiscard]] PreparationStep breakStep(const SampleClock& clock);
[[nodiscard]] PreparationStep jitterStep(const SampleClock& clock, bool moved);
[[nodiscard]] PreparationStep lostStep(const WindowChoice& choice);
[[nodiscard]] PreparationStep cutStep(Window used, Window squeeze);
[[nodiscard]] PreparationStep contactLossStep(const std::vector<std::size_t>& away, std::size_t samples);
[[nodiscard]] PreparationStep frameStep(double compliance);
[[nodiscard]] PreparationStep openingStep(std::size_t samples);
[[nodiscard]] PreparationStep spikesStep(const HeldPosition& held);
[[nodiscard]] PreparationStep heldStep(const HeldPosition& held);

/// Samples at a sensor's end by the device's word (status bits) or by their look (clippedSamples()).
[[nodiscard]] std::optional<PreparationStep> saturationStep(const Recording& recording, Window used,
                                                            bool positionIsHeld);
/// A position that comes in steps larger than its noise and than a ten-thousandth of its range: its errors
/// are then neither white nor independent of the motion.
/// `step` is that of their lattice, zero where there is none.
[[nodiscard]] std::optional<PreparationStep> quantizationStep(std::span<const double> positions, double step,
                                                              const QString& unit);

} // namespace gripscope
