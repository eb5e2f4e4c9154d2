// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/stop_words.h"

#include "core/base/words.h"
#include "core/signal/recording/recording.h"

namespace gripscope {

QString ownReason(std::uint16_t status)
{
    if (status & StatusFault)
        return Words::tr("it reports a fault");
    if (status & StatusForceLimit)
        return Words::tr("the force limit was reached");
    if (status & StatusTravelLimit)
        return Words::tr("the travel limit was reached");
    if (status & StatusWatchdog)
        return Words::tr("it no longer heard from this program");
    return {};
}

} // namespace gripscope
