// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/verdict.h"

#include <array>

namespace gripscope {

/// What an inspection shows: one of six outcomes that never share a word or a colour. Nothing is held against
/// the part by the last two of the recognition, Inconclusive and NotValid: they call for another squeeze.
/// DoesNotConform is of the right type, and beyond its limits; it comes last, since outcomes are stored as
/// numbers in nothing but orders.
enum class InspectionOutcome { AsExpected, OtherType, Unknown, Inconclusive, NotValid, DoesNotConform };
inline constexpr std::array allInspectionOutcomes{
    InspectionOutcome::AsExpected, InspectionOutcome::OtherType,    InspectionOutcome::DoesNotConform,
    InspectionOutcome::Unknown,    InspectionOutcome::Inconclusive, InspectionOutcome::NotValid};

/// What was found of a part: whether it is of a type, and how it stands to the limits of that.
struct PartJudged {
    VerdictKind kind = VerdictKind::Invalid;
    std::optional<ConformityDecision> conformity = {}; ///< absent: no limits, or no type
    PartJudged(VerdictKind recognised,
               std::optional<ConformityDecision> limits = {}) // NOLINT(google-explicit-constructor)
        : kind(recognised), conformity(limits)
    {
    }
    explicit PartJudged(const Verdict& verdict);
};
/// "type", "type does_not_conform", as inspections are counted by.
[[nodiscard]] std::optional<PartJudged> partJudgedFromString(const QString& text);

/// With nothing expected every named type is AsExpected, which is then told as a "known type". Too near a
/// limit, or not decidable, is Inconclusive.
[[nodiscard]] InspectionOutcome inspectionOutcome(const PartJudged& judged, const QString& type,
                                                  const QString& expectedType);
[[nodiscard]] QString toString(InspectionOutcome outcome); ///< "as_expected", "other_type", ...

} // namespace gripscope
