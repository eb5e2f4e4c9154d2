// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze_obstacle.h"

#include "core/words.h"

#include <algorithm>

namespace gripscope {

QString obstacleOf(std::span<const Identification> squeezes)
{
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        const Validity& validity = squeezes[i].validity;
        if (validity.verdict != ValidityVerdict::Invalid)
            continue;
        const auto decisive = std::find_if(validity.checks.begin(), validity.checks.end(),
                                           [](const auto& check) { return !check.ok && check.decisive; });
        return Words::tr("squeeze %1: %2")
            .arg(i + 1)
            .arg(decisive != validity.checks.end() ? decisive->message : toString(validity.verdict));
    }
    return {};
}

} // namespace gripscope
