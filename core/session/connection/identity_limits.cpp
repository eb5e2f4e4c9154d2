// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/identity_limits.h"

#include "core/base/words.h"
#include "core/signal/recording/recording_limits.h"

#include <cmath>

namespace gripscope {

std::optional<Finding> outOfRange(const GripperIdentity& identity)
{
    if (!isSampleTime(identity.sampleTime_s))
        return Words::say("its sample time is %1 s and not %2")
            .arg(identity.sampleTime_s)
            .arg(sampleTimeExpectation());
    if (!(std::abs(identity.forceLag_s) <= longestForceLag_s))
        return Words::say("its force lag is %1 s, at most %2 s can be")
            .arg(identity.forceLag_s)
            .arg(longestForceLag_s);
    return std::nullopt;
}

} // namespace gripscope
