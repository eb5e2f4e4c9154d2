// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/output_error/output_error.h"

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

/// What the rows of one record, or of several, add up to, whitened by the noise and freed of what m, b, k,
/// start and offset can imitate: e the residuals under the declared hold, d the difference between the two
/// fitted models, v what one standard uncertainty of the lag moves. All are in units of the noise. Sums of
/// independent squeezes of one device add up.
struct HoldSums {
    double difference = 0;    ///< d'd
    double residual = 0;      ///< e'd
    double lag = 0;           ///< v'v
    double lagDifference = 0; ///< v'd
    double lagResidual = 0;   ///< v'e
};

/// What a record, or several, says about the force hold that was declared.
///
/// The other hold moves the model's position by about half a sample, as a lag would. The lag is one unknown
/// number of the device with the prior N(0, u^2) about the declared one; integrated out, it leaves
/// S = I - v v' / (1 + v'v) of the rows of all squeezes together, and
///     gain = e'Sd - d'Sd / 2        log-likelihood of the other hold over the declared one,
///     expectedGain = d'Sd / 2       its mean if the other hold is true; if the declared one is, it is minus
///     that,
/// and the gain scatters by sqrt(2 expectedGain) either way (Kullback and Leibler 1951; Box and Hill 1967). A
/// lag that is not known well leaves no more than a bounded gain, however many the squeezes.
struct HoldEvidence {
    ForceHold declared = ForceHold::First;
    double lag_s = 0, lagUncertainty_s = 0; ///< as declared
    std::optional<double> gain;             ///< absent: not judged
    double expectedGain = 0;
    /// m, b, k under the declared hold and the other one; of the last squeeze where several were combined.
    std::optional<MassDampingStiffness> parameters, otherParameters;
    int squeezes = 0; ///< that gain and expectedGain are about
    HoldSums sums;

    /// Of the other hold after the data, both being as likely before: 1 / (1 + exp(-gain)). One half without
    /// data.
    [[nodiscard]] double otherProbability() const;
    /// Contradicts: gain over 10, or over 2.5 where the expected gain is over 8. At an expected gain of 10
    /// that finds 95 % of wrong declarations. A right one is accused in 0.5 % at the most; when the sum is
    /// looked at after every squeeze, in 1.2 % at the most, ever (Wald 1945).
    [[nodiscard]] HoldVerdict verdict() const;
    /// The gain above which the verdict is Contradicts.
    [[nodiscard]] double limit() const;
    /// The same hold, lag and uncertainty of the lag are declared: only then does the evidence add up.
    [[nodiscard]] bool declaresAs(const HoldEvidence& other) const;
};

/// The record under the other hold, begun at the estimate `oe` under `options`; as it is where `oe` did not
/// converge.
[[nodiscard]] Estimate estimateOtherHold(const std::vector<double>& force,
                                         const std::vector<double>& position,
                                         const OutputErrorOptions& options, const Estimate& oe);

/// `oe` is the estimate by output error under `options`, `other` that of estimateOtherHold(). Nothing is
/// judged where one of them did not converge. `lagUncertainty_s`: standard uncertainty of options.lag_s; from
/// half a sample time on nothing can be told, and gain and expectedGain are 0. What the other declaration
/// would find is the same with the sign of the gain turned.
[[nodiscard]] HoldEvidence weighHolds(const std::vector<double>& force, const OutputErrorOptions& options,
                                      const Estimate& oe, const Estimate& other, double lagUncertainty_s);

/// Evidence of independent squeezes of one device adds up; its lag is the same unknown in all of them. Only
/// those count that were judged and declare what the last one does: hold, lag and the lag's uncertainty.
[[nodiscard]] HoldEvidence combine(std::span<const HoldEvidence> squeezes);

} // namespace gripscope
