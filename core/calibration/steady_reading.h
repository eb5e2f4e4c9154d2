// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>

namespace gripscope {

enum class SteadyStatus { Steady, Moving, TooFewSamples };

/// What a channel said while nothing moved.
struct SteadyReading {
    SteadyStatus status = SteadyStatus::TooFewSamples;
    double mean = 0;
    double deviation = 0; ///< standard deviation of single samples
    double drift = 0;     ///< from the beginning to the end, by a straight line
    std::size_t samples = 0;
};

struct SteadyOptions {
    std::size_t leastSamples = 20;
    double driftAllowed = 0; ///< a smaller drift is of no account, in the channel's unit
};

/// Mean of `values`, evenly spaced in time, all finite. Moving: a straight line through the means of ten
/// blocks drifts by more than is allowed and by more than its own noise explains (Student's t, 8 degrees of
/// freedom, p = 0.001); blocks, since neighbouring samples need not be independent. Linear in the samples.
[[nodiscard]] SteadyReading steadyReading(std::span<const double> values, const SteadyOptions& options);

} // namespace gripscope
