// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/capability.h"

#include <array>
#include <cstdint>

namespace gripscope {

struct PercentileOptions {
    ToleranceLimits limits;
    double confidence = 0.95;
    int resamples = 4000;
    std::uint64_t seed = 1;
};

struct PercentileCapability {
    double low = 0, median = 0, high = 0;  ///< 0.135, 50 and 99.865 %
    std::optional<CapabilityIndex> spread; ///< Pp; two limits only
    CapabilityIndex nearest;               ///< Ppk
    double observedPpm = 0;
    Findings messages;
};

/// Capability of values of any distribution by their own percentiles (ISO 22514-2:2017):
///     Pp = (U - L)/(q99.865 - q0.135),  Ppk = min((U - q50)/(q99.865 - q50), (q50 - L)/(q50 - q0.135)),
/// percentiles between order statistics at h = (n + 1/3) p + 1/3 (Hyndman and Fan 1996, type 8). Intervals by
/// the bootstrap's percentiles (Efron 1979); a resample's order statistics are drawn as what they are, order
/// statistics of uniform ranks, so that a million values cost no more than a hundred. Below 1,000 values the
/// outer percentiles are the smallest and the largest value: indices are then too good, and that is said.
/// Assumes independent values of a stable process. Usage: as studyCapability(). BadInput: fewer than 8
/// values, or values that do not vary.
[[nodiscard]] Expected<PercentileCapability> studyPercentileCapability(std::span<const double> values,
                                                                       const PercentileOptions& options);

/// Where the order statistics of resamples lie among so many sorted values, six places a resample. Nothing
/// else of the values counts: m, b and k of the same inspections share them.
struct ResampledRanks {
    std::size_t count = 0; ///< values
    std::vector<std::array<std::size_t, 6>> drawn;
};
[[nodiscard]] ResampledRanks resampledRanks(std::size_t count, int resamples, std::uint64_t seed);
/// The same of values that are sorted already, ascending, with the ranks of as many, which stand for
/// resamples and seed.
[[nodiscard]] Expected<PercentileCapability> studyPercentileCapability(std::span<const double> sorted,
                                                                       const ResampledRanks& ranks,
                                                                       const PercentileOptions& options);

} // namespace gripscope
