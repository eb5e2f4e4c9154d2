// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/limits/guard_bands.h"

#include <QString>

#include <array>
#include <optional>

namespace gripscope {

/// By which a measured value within or beyond its limits is taken to prove that the part is, too.
enum class ConformityRule {
    /// ISO 14253-1:2017: proven beyond a guard band of the one-sided expanded uncertainty of 95 % on the near
    /// side of the limit.
    Iso14253,
    Simple,       ///< the value alone decides (JCGM 106:2012, 8.2); nothing is too near then
    ConsumersRisk ///< proven where the risk to be wrong is at most a stated one (JCGM 106:2012, 8.3)
};
[[nodiscard]] QString toString(ConformityRule rule); ///< "iso14253", "simple", "risk"
[[nodiscard]] std::optional<ConformityRule> conformityRuleFromString(const QString& text);

/// What m, b and k of the parts of a type may be, in the units that follow from the type's channels.
struct PartLimits {
    std::array<std::optional<ToleranceLimits>, 3> quantities = {}; ///< of m, b, k; nothing: no limit
    ConformityRule rule = ConformityRule::Iso14253;
    double risk = 0.05; ///< of ConsumersRisk; above 0, below 0.5

    [[nodiscard]] bool isEmpty() const; ///< no quantity has one
    /// Usage: none at all, a limit that is not above zero, those of ToleranceLimits, a risk out of range.
    [[nodiscard]] std::optional<Error> validate() const;
    friend bool operator==(const PartLimits&, const PartLimits&) = default;
};

/// "m", "b", "k".
[[nodiscard]] QString quantitySymbol(std::size_t place);

/// "k=11.5:12.5 m=:0.05 rule=iso14253", by which limits are stored and audited; numbers read back to the same
/// bits. Empty: no limits.
[[nodiscard]] QString toText(const PartLimits& limits);
/// Nothing for what toText() does not write, and for limits that validate() refuses. No limits for an empty
/// text.
[[nodiscard]] std::optional<PartLimits> partLimitsFromText(const QString& text);

/// "11.5:12.5", ":12.5", "11.5:" as a person types it; nothing where it is none of these.
[[nodiscard]] std::optional<ToleranceLimits> toleranceLimitsFromText(const QString& text);
[[nodiscard]] QString toText(const ToleranceLimits& limits);

} // namespace gripscope
