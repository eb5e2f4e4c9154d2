// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace gripscope {

/// The times by which a link keeps a person safe. A test that is about something else may widen them, so that
/// a busy computer does not fail it; the program itself takes them as they are.
struct LinkLimits {
    using ms = std::chrono::milliseconds;

    ms heartbeatPeriod{25};  ///< a quarter of the shortest watchdog
    ms aliveFor{500};        ///< heartbeats end so long after the screen stood still
    ms freshFor{50};         ///< without a good sample for so long an armed gripper is stopped
    ms reportPeriod{20};     ///< one whose reports come less often is not armed
    int attempts = 10;       ///< so often a command is sent that nothing answers
    ms silenceLimit{1000};   ///< a device that says nothing is taken for lost
    int stops = 3;           ///< so often Stop is sent, whatever is answered
    ms stopSpacing{20};      ///< between them
    ms obeyWithin{150};      ///< then it is disarmed and its force is gone, or it did not obey
    ms writerMayWait{50};    ///< from the wish to stop until the first Stop is written
    ms watchdogMargin{50};   ///< a watchdog may trip so much later than it states
    ms forgetForeign{1000};  ///< an answer to another program's command keeps it from being armed for so long
    ms deafReaderLimit{850}; ///< behind obeyWithin: a reader that hangs itself can confirm nothing
    /// For tests: the watchdog of a virtual gripper waits so much longer once it has tripped, as it does when
    /// the first arming proves it.
    ms virtualPatience{0};
};

} // namespace gripscope
