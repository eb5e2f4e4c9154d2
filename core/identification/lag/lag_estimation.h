// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/identification/model/estimate.h"

#include <QString>

#include <optional>
#include <span>
#include <vector>

namespace gripscope {

enum class LagStatus {
    Measured,
    TooUncertain, ///< known less well than it takes to tell it from none: only the device's own lag may be
                  ///< used
    HoldOrLag, ///< the hold is not known, and the other one with a lag of its own explains the record as well
    AtLimit,   ///< the best lag lies at the end of the range searched
    NotEstimated, ///< too little data, or no estimate of m, b and k
};

struct LagEstimationOptions {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::First;
    bool holdIsKnown = true;       ///< false: whether the other hold does as well is tried too
    double expectedLag_s = 0;      ///< the middle of the range searched
    double searchedSamples = 2;    ///< half of that range, in sample times; 1/2 to 20
    std::vector<std::size_t> lost; ///< indexes where nothing was measured
};

/// How much later the position channel samples than the force channel.
struct LagEstimate {
    LagStatus status = LagStatus::NotEstimated;
    double lag_s = 0;
    double standardError_s = 0;
    /// The log-likelihood that a lag of half a sample costs when it is taken for none, (T/2)^2 / (2 error^2).
    /// Half a sample is what the wrong force hold amounts to; above 10 it shows.
    double expectedGain = 0;
    /// By how much the other hold with its own best lag is less likely; absent when it was not tried.
    std::optional<double> holdGain;
    double sampleTime_s = 0;
    int squeezes = 1;
    Finding message;

    [[nodiscard]] bool hasValue() const
    {
        return status == LagStatus::Measured || status == LagStatus::TooUncertain;
    }
};

/// The lag as one more parameter beside m, b, k, x0, v0 and offset, by output error: the sum of squares,
/// smallest in all others, is searched over the lag (Brent 1973) behind a scan in half samples, on the same
/// rows throughout. The standard error follows from its curvature, which counts the correlation with all
/// other parameters: var = 2 s^2 / (d^2 SSE / d lag^2) (profile likelihood; Seber and Wild, Nonlinear
/// Regression, ch. 5).
///
/// A free lag doubles the error of m, so it is measured once, on some squeezes of a stiff spring or a can of
/// any kind (combineLags()), and declared as a property of the device with its uncertainty. From a squeeze
/// that is to be judged itself it may be used where the status is Measured, that is where expectedGain is
/// above 10 and the hold is known or told.
///
/// Force and position equally long, all numbers finite, the sample time positive; else NotEstimated.
[[nodiscard]] LagEstimate estimateLag(const std::vector<double>& force, const std::vector<double>& position,
                                      const LagEstimationOptions& options);

/// The lag of the device from several squeezes: their pooledMean(), so that a model that does not quite fit
/// makes the error larger, not the lag wrong. Estimates without a value do not count.
[[nodiscard]] LagEstimate combineLags(std::span<const LagEstimate> squeezes);

} // namespace gripscope
