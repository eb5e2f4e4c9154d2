// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/connect_session.h"
#include "tests/core/session/fake_gripper.h"
#include "tests/support/patience.h"

#include <chrono>
#include <functional>
#include <thread>

namespace gripscope::test {

/// Polls until `done`, as the owner of a session does; false when it takes longer than any of this should.
inline bool pollUntil(const std::function<void()>& poll, const std::function<bool()>& done)
{
    PatienceLeft left;
    while (!done()) {
        if (left.isOver())
            return false;
        poll();
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return true;
}

/// A connection to a fake gripper, open and armed.
struct ArmedConnection {
    FakeGripperFactory factory;
    ConnectSession session{factory};

    FakeGripper& gripper() { return *factory.gripper; }

    bool open(bool arm = true)
    {
        if (!session.connectTo(QStringLiteral("fake:")))
            return false;
        session.poll();
        if (session.state() != ConnectSession::State::Connected)
            return false;
        if (!arm)
            return true;
        const bool accepted = session.arm(QStringLiteral("Ada")).has_value();
        session.poll(); // which is when a session learns it
        return accepted && session.armed();
    }
};

} // namespace gripscope::test
