// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/limits/tolerance_limits.h"

namespace gripscope {

/// A normal process and a normal measurement of it, without bias.
struct MeasuredProcess {
    ToleranceLimits limits;
    double mean = 0, deviation = 0; ///< of the parts
    double uncertainty = 0;         ///< standard, of a measurement; above zero
    [[nodiscard]] std::optional<Error> validate() const;
};

/// Global risks (JCGM 106:2012, 9.3): acceptance limits lie `guard` within the tolerance limits (negative:
/// beyond them), g is the density of the parts, A the probability that a part eta is accepted:
///     consumer's = integral outside of g A,   producer's = integral inside of g (1 - A).
/// By Gauss-Kronrod to 1e-10.
struct GlobalRisks {
    double consumers = 0; ///< a part that does not conform is accepted
    double producers = 0; ///< a part that conforms is rejected
};
[[nodiscard]] Expected<GlobalRisks> globalRisks(const MeasuredProcess& process, double guard);

/// The smallest guard band by which the consumer's risk is at most `risk`; nothing where none is (acceptance
/// limits that meet end the search). Errors as globalRisks().
[[nodiscard]] Expected<std::optional<double>> guardForRisk(const MeasuredProcess& process, double risk);

/// The guard band by which a value at the acceptance limit has a specific risk of `risk` at one limit (ISO
/// 14253-1:2017 takes 5 %: 1.645 u). u above zero, risk between 0 and 0.5.
[[nodiscard]] double guardForSpecificRisk(double uncertainty, double risk);

/// What is known of the parts beforehand.
struct PartsBefore {
    double mean = 0, deviation = 0;
};
/// The probability that a part measured as `value` conforms (JCGM 106:2012, 7.2); with `before` by Bayes'
/// rule, else from the measurement alone.
[[nodiscard]] double conformanceProbability(const ToleranceLimits& limits, double value, double uncertainty,
                                            const std::optional<PartsBefore>& before = std::nullopt);

enum class PartDecision { Conforms, DoesNotConform, TooNearTheLimit };
/// Conforms where the probability not to is at most `risk`, does not where that to conform is.
[[nodiscard]] PartDecision decide(double conformanceProbability, double risk);

} // namespace gripscope
