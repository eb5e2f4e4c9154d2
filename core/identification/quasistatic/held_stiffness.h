// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/signal/preparation/held_position.h"
#include "core/signal/recording/measuring_chain.h"

namespace gripscope {

/// The share of the most that the part may have yielded from which on the least gives an upper bound: k
/// within a factor of four. Below it the least is a small difference of large numbers, and a gripper's own
/// yielding would pass for a part's.
inline constexpr double leastTravelShare = 0.25;

/// k of the loading of a squeeze whose position is held, by set membership (Milanese and Vicino, Automatica
/// 27, 1991): no statistics, only what cannot be excluded.
///
///     k = (F2 - F1) / (x(t2) - x(t1)),   F1 = 5 %, F2 = 90 % of the largest force of the contact,
/// the secant of a spring that need not be straight. t2 is when the force first reaches F2, t1 when it last
/// passed F1 before. Wide, since travel grows with the range of force and what is not known of it does not.
///
/// The position at t is what the channel shows at t + clock, with one unknown clock in
/// held.clockOffset_s +- held.clockBound_s; there, it lies between the value that stands and the next one
/// that will stand. The least and the most of x(t2) - x(t1) over all of that, each wider by 95 % of the
/// force's noise, bound k. Row by row the values between neighbours count as possible.
///
/// Assumes: the position moves one way between two renewals, both clocks run alike during the loading, the
/// part is a spring there. What yields in series with the part is in k but for the chain's frame compliance,
/// which is taken off the travel with its uncertainty. Units those of the channels; k force over position.
///
/// - The least is at least leastTravelShare of the most: Converged, a motion without mass and damping whose k
///   is the middle of the bounds (in the logarithm), and both bounds.
/// - The most is above zero: NotIdentifiable with the lower bound alone.
/// - Else, and where the record does not reach as far before and behind the loading as the clocks may be
///   apart: NotIdentifiable without one.
/// The message names the range of force, always. Never mass or damping.
[[nodiscard]] Estimate estimateHeldStiffness(const HeldPosition& held, const MeasuringChain& chain);

/// What all other estimators, `estimator` among them, answer to such a record: NotApplicable, with what is
/// wrong with it and what to do.
[[nodiscard]] Estimate notOfHeldPosition(Estimator estimator, const HeldPosition& held);

} // namespace gripscope
