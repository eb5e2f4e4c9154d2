// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/instrument_range.h"
#include "core/recognition/predictive.h"

#include <optional>
#include <vector>

namespace gripscope {

/// Where a squeeze is named a type rather than taken for a stranger.
struct StrangerLimit {
    /// Share of strangers inside the gates, before and after the limit. Gates that overlap count twice, and
    /// what lies outside the instrument's range too: it may only be less.
    double insideGates = 0, accepted = 0;
    /// Log of the least density a type must have; absent where the gates alone keep the rate.
    std::optional<double> leastLogDensity;
};

/// The region of the likelihood ratio test of types against strangers that holds a share of at most `rate` of
/// all strangers: density above a level, and inside the gate. `gates`: squared distances, one a type.
/// (Volume of an ellipsoid d' V^-1 d <= q: 4/3 pi q^(3/2) |V|^(1/2).)
[[nodiscard]] StrangerLimit strangerLimit(const std::vector<TypePrediction>& predictions,
                                          const std::vector<double>& gates, double logVolume, double rate);

} // namespace gripscope
