// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/gripper_port.h"

#include "core/session/connection/gripper_return.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(LinkState state)
{
    switch (state) {
    case LinkState::Closed:
        return u"closed"_qs;
    case LinkState::Opening:
        return u"opening"_qs;
    case LinkState::Ready:
        return u"ready"_qs;
    case LinkState::Armed:
        return u"armed"_qs;
    case LinkState::Lost:
        return u"lost"_qs;
    case LinkState::Closing:
        return u"closing"_qs;
    }
    return {};
}

LinkCounters& LinkCounters::operator+=(const LinkCounters& later)
{
    const LinkCounters earlier = *this;
    *this = later;
    reports += earlier.reports;
    samples += earlier.samples;
    lostSamples += earlier.lostSamples;
    sequenceGaps += earlier.sequenceGaps;
    lastLoss = later.lastLoss ? later.lastLoss : earlier.lastLoss;
    duplicateReports += earlier.duplicateReports;
    badReports += earlier.badReports;
    droppedSamples += earlier.droppedSamples;
    clockSteps += earlier.clockSteps;
    stalls += earlier.stalls;
    longestStall_s = std::max(earlier.longestStall_s, later.longestStall_s);
    commandsSent += earlier.commandsSent;
    commandsRepeated += earlier.commandsRepeated;
    commandsAnswered += earlier.commandsAnswered;
    commandsRefused += earlier.commandsRefused;
    commandsUnanswered += earlier.commandsUnanswered;
    heartbeats += earlier.heartbeats;
    return *this;
}

std::unique_ptr<GripperReturn> GripperPortFactory::awaitReturn(const AwaitedGripper&)
{
    return nullptr;
}

} // namespace gripscope
