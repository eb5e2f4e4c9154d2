// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze_obstacle.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

QString obstacleOf(std::span<const Identification> squeezes)
{
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        const Validity& validity = squeezes[i].validity;
        if (validity.verdict != ValidityVerdict::Invalid)
            continue;
        const auto decisive = std::find_if(validity.checks.begin(), validity.checks.end(),
                                           [](const auto& check) { return !check.ok && check.decisive; });
        return u"squeeze %1: %2"_s.arg(i + 1).arg(
            decisive != validity.checks.end() ? decisive->message : toString(validity.verdict));
    }
    return {};
}

} // namespace gripscope
