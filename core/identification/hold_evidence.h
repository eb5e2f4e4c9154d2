// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/identification/output_error.h"

#include <optional>
#include <span>
#include <vector>

namespace gripscope {

enum class HoldVerdict {
    NotJudged,
    Agrees,     ///< these data tell the holds apart, and the declared one is right
    Ambiguous,  ///< they cannot: the difference belongs in the errors of m and b
    Contradicts ///< the other hold is right, or the lag between the channels is not what was declared
};

/// What a record, or several, says about the force hold that was declared.
///
/// The other hold moves the model's position by about half a sample, as a lag would. Let e be the residuals
/// under the declared hold, d the difference between the two fitted models, both whitened by the residuals'
/// noise model, freed of what m, b, k, start and offset can imitate, and of the velocity as far as the lag's
/// prior N(0, u^2) allows (a ridge, that is the lag integrated out). Then
///     gain = e'd - d'd / 2          log-likelihood of the other hold over the declared one,
///     expectedGain = d'd / 2        its mean if the other hold is true; if the declared one is, it is minus
///     that,
/// and the gain scatters by sqrt(2 expectedGain) either way (Kullback and Leibler 1951; Box and Hill 1967).
struct HoldEvidence {
    ForceHold declared = ForceHold::First;
    std::optional<double> gain; ///< absent: not judged
    double expectedGain = 0;
    /// m, b, k under the other hold; of the last squeeze where several were combined.
    std::optional<MassDampingStiffness> otherParameters;
    int squeezes = 0; ///< that gain and expectedGain are sums over

    /// Of the other hold after the data, both being as likely before: 1 / (1 + exp(-gain)). One half without
    /// data.
    [[nodiscard]] double otherProbability() const;
    /// Contradicts: gain over 10, or over 2.5 where the expected gain is over 8. At an expected gain of 10
    /// that finds 95 % of wrong declarations; a right one is accused in 0.5 % at the most.
    [[nodiscard]] HoldVerdict verdict() const;
    /// The gain above which the verdict is Contradicts.
    [[nodiscard]] double limit() const;
};

/// `oe` is the estimate by output error under `options`. Nothing is judged for an estimate that did not
/// converge, or when nothing converges under the other hold. `lagUncertainty_s`: standard uncertainty of
/// options.lag_s; when it is near half a sample time, nothing can be told and expectedGain is small.
[[nodiscard]] HoldEvidence weighHolds(const std::vector<double>& force, const std::vector<double>& position,
                                      const OutputErrorOptions& options, const Estimate& oe,
                                      double lagUncertainty_s);

/// Evidence of independent squeezes adds up. Those that were not judged, or were declared otherwise than the
/// first that was, do not count.
[[nodiscard]] HoldEvidence combine(std::span<const HoldEvidence> squeezes);

} // namespace gripscope
