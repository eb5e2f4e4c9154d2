// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/measured_together.h"

#include "core/words.h"

#include <algorithm>

namespace gripscope {

tl::expected<RepeatedMeasurement, QString> measuredTogether(std::span<const Identification> squeezes)
{
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        const Validity& validity = squeezes[i].validity;
        if (validity.verdict != ValidityVerdict::Invalid)
            continue;
        const auto decisive = std::find_if(validity.checks.begin(), validity.checks.end(),
                                           [](const auto& check) { return !check.ok && check.decisive; });
        return tl::unexpected(
            Words::tr("squeeze %1: %2")
                .arg(i + 1)
                .arg(decisive != validity.checks.end() ? decisive->message : toString(validity.verdict)));
    }
    if (const std::optional<RepeatedMeasurement> found = repeatedMeasurement(squeezes))
        return *found;
    return tl::unexpected(Words::tr("no m, b and k above zero were found with their uncertainty"));
}

} // namespace gripscope
