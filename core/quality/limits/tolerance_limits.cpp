// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/limits/tolerance_limits.h"

#include "core/base/words.h"

#include <cmath>

namespace gripscope {

namespace {

Error unusableLimits(const Finding& words)
{
    return Error{ErrorCode::Usage, {words}};
}

} // namespace

std::optional<Error> ToleranceLimits::validate() const
{
    if (!lower && !upper)
        return unusableLimits(Words::say("no limit is given: a lower one, an upper one or both"));
    for (const std::optional<double>& limit : {lower, upper})
        if (limit && !std::isfinite(*limit))
            return unusableLimits(Words::say("a limit is no finite number"));
    if (lower && upper && !(*lower < *upper))
        return unusableLimits(Words::say("the lower limit is not below the upper one"));
    return std::nullopt;
}

} // namespace gripscope
