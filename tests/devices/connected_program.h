// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/connect_session.h"
#include "core/session/squeeze/squeeze_job.h"
#include "tests/devices/port_helpers.h"

namespace gripscope::test {

/// A session on a gripper, driven as a program drives it.
struct ConnectedProgram {
    DeviceFactory factory = patientFactory();
    ConnectSession connection{factory};
    SqueezeJob job{connection};
    std::function<void()> alsoDrive; ///< what else has to run meanwhile, such as a device

    void poll()
    {
        if (alsoDrive)
            alsoDrive();
        connection.poll();
        job.poll();
    }
    bool until(const std::function<bool()>& condition)
    {
        return waitFor([&] {
            poll();
            return condition();
        });
    }
    bool untilState(ConnectSession::State state)
    {
        return until([&] { return connection.state() == state; });
    }
    bool untilSamples(std::uint64_t more)
    {
        const std::uint64_t enough = connection.counters().samples + more;
        return until([&] { return connection.counters().samples >= enough; });
    }
    bool connectTo(const QString& address)
    {
        return connection.connectTo(address).has_value() && untilState(ConnectSession::State::Connected);
    }
    /// Asked for again each second: a gripper that a busy computer kept waiting ends its arming by its
    /// watchdog, and asking twice is harmless.
    bool arm()
    {
        const auto ask = [this] { return connection.arm(QStringLiteral("tester")).has_value(); };
        auto asked = std::chrono::steady_clock::now();
        return ask() && until([&] {
                   if (connection.armed() ||
                       std::chrono::steady_clock::now() - asked < std::chrono::seconds(1))
                       return connection.armed();
                   asked = std::chrono::steady_clock::now();
                   static_cast<void>(ask()); // refused while it is not ready; then the next one
                   return false;
               });
    }
    /// For a test that waited in vain.
    [[nodiscard]] QString whatHolds() const
    {
        const LinkCounters counters = connection.counters();
        return QStringLiteral("state %1, %2 reports (%3 bad), %4 samples; %5")
            .arg(QString::number(int(connection.state())), QString::number(counters.reports),
                 QString::number(counters.badReports), QString::number(counters.samples),
                 connection.lastError() ? connection.lastError()->describe() : QString());
    }
    /// To its end, good or bad; false: it did not begin.
    bool squeeze(double seconds = 0.2)
    {
        Recipe recipe;
        recipe.seconds = seconds;
        return job.start(recipe, 1).has_value() && until([&] {
                   return job.state() == SqueezeJob::State::Done || job.state() == SqueezeJob::State::Failed;
               });
    }
};

} // namespace gripscope::test
