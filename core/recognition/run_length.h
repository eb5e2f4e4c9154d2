// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace gripscope {

/// Limit of |e_t|^2 (2 - w) / w for an exponentially weighted moving average
///     e_t = w z_t + (1 - w) e_{t-1},  e_0 = 0,  z_t ~ N(0, I) in so many dimensions, independent,
/// that is passed for the first time after `averageRunLength` steps on average: Roberts's EWMA chart with one
/// dimension, Lowry's MEWMA chart (Hotelling's T^2 of the averages) with more. By the Markov chain of the
/// length of e_t (Runger and Prabhu, A Markov chain model for the multivariate exponentially weighted moving
/// averages control chart, 1996); 60 states know the run length to a hundredth. Nothing for w outside 0.01 to
/// 1, run lengths outside 5 to 1e6, or dimensions below 1.
[[nodiscard]] std::optional<double> movingAverageLimit(double weight, int dimensions,
                                                       double averageRunLength);

/// The other way round. Nothing for a limit that is not above zero.
[[nodiscard]] std::optional<double> averageRunLength(double weight, int dimensions, double limit);

} // namespace gripscope
