// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/acquisition/link_limits.h"
#include "tests/support/patience.h"

namespace gripscope::test {

/// A link that bears a program whose threads others keep from the processor; what it expects of the gripper
/// stays as it is, and so does what the gripper does when no heartbeat ever comes.
inline LinkLimits limitsForABusyProgram()
{
    using std::chrono::milliseconds;
    LinkLimits limits;
    limits.aliveFor = milliseconds(longEnough_ms);
    limits.obeyWithin = milliseconds(10'000);
    limits.writerMayWait = milliseconds(10'000);
    limits.deafReaderLimit = milliseconds(10'000);
    limits.virtualPatience = milliseconds(longEnough_ms); // heartbeats may be kept waiting, too
    return limits;
}

/// One that bears a late reader and late reports, too.
inline LinkLimits patientLimits()
{
    using std::chrono::milliseconds;
    LinkLimits limits = limitsForABusyProgram();
    limits.freshFor = milliseconds(10'000);
    limits.reportPeriod = milliseconds(10'000);
    limits.silenceLimit = milliseconds(longEnough_ms);
    limits.attempts = 100; // ten seconds: commands are repeated while a busy reader reads no answers
    limits.watchdogMargin = milliseconds(1'000); // also how long it is silent after Stop
    return limits;
}

/// Patient, but for a program that stands still: its heartbeats end, and then the gripper stops by itself.
inline LinkLimits limitsForAFrozenProgram()
{
    LinkLimits limits = patientLimits();
    limits.aliveFor = LinkLimits().aliveFor;
    limits.virtualPatience = LinkLimits().virtualPatience;
    return limits;
}

} // namespace gripscope::test
