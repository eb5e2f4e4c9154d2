// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/quality/conformity/part_limits.h"

namespace gripscope {

/// A quantity as one squeeze found it, in the units of the limits.
struct MeasuredValue {
    double value = 0;
    std::optional<double> standardUncertainty = {}; ///< absent: not known
    std::optional<double> degreesOfFreedom = {};    ///< behind it; absent: as good as infinite
};
/// m, b, k; nothing where the squeeze did not determine it.
using MeasuredValues = std::array<std::optional<MeasuredValue>, 3>;

/// NotDecidable: not measured, or not with a known uncertainty. It says nothing against the part, nor does
/// TooNearTheLimit.
enum class ConformityDecision { Conforms, DoesNotConform, TooNearTheLimit, NotDecidable };
[[nodiscard]] QString toString(ConformityDecision decision); ///< "conforms", "does_not_conform", ...
[[nodiscard]] std::optional<ConformityDecision> conformityDecisionFromString(const QString& text);

struct QuantityConformity {
    ConformityDecision decision = ConformityDecision::NotDecidable;
    ToleranceLimits limits = {};
    std::optional<double> value = {}, standardUncertainty = {};
    std::optional<double> guard = {}; ///< width of the guard band on either side of a limit
    /// Specific risk: the probability that the part does not conform, given value and uncertainty.
    std::optional<double> risk = {};
    friend bool operator==(const QuantityConformity&, const QuantityConformity&) = default;
};

struct Conformity {
    ConformityDecision decision = ConformityDecision::NotDecidable;
    std::array<std::optional<QuantityConformity>, 3> quantities = {}; ///< of m, b, k: those with limits
    ConformityRule rule = ConformityRule::Iso14253;
    double statedRisk = 0.05;            ///< of ConformityRule::ConsumersRisk
    std::optional<double> siFactor = {}; ///< takes the values to SI; absent: their units are not known
    friend bool operator==(const Conformity&, const Conformity&) = default;
};

/// With y the value, u its standard uncertainty with v degrees of freedom, T Student's distribution with v
/// (normal where v is absent), TL <= TU the limits; a side that is open is infinitely far:
///
///     risk  = P(T < (TL - y)/u) + P(T < (y - TU)/u)
///     guard = t(0.95; v) u for Iso14253, 0 for Simple, t(1 - stated risk; v) u for ConsumersRisk
///
/// Iso14253 and Simple: conforms for TL + guard <= y <= TU - guard, does not for y <= TL - guard or
/// y >= TU + guard (Simple: on the limit it conforms), else it is too near. ConsumersRisk: conforms for
/// risk <= stated, does not for 1 - risk <= stated, else too near: with two limits close together both tails
/// count, which a guard band at each does not see.
///
/// Overall: does not conform where any quantity does not, conforms where all do, else too near where any is,
/// else not decidable. Error: that of PartLimits::validate(). Source: JCGM 106:2012, 7 and 8; ISO
/// 14253-1:2017.
[[nodiscard]] Expected<Conformity> judgeConformity(const PartLimits& limits, const MeasuredValues& measured,
                                                   const std::optional<double>& siFactor = {});

/// "conforms", "does not conform", "too near the limit for this squeeze", "not decidable by this squeeze".
[[nodiscard]] Finding inWords(ConformityDecision decision);
/// The same with what decides: "Does not conform: k 12.9 kN/m is above 12.5 kN/m."
[[nodiscard]] Finding inWords(const Conformity& conformity);

} // namespace gripscope
