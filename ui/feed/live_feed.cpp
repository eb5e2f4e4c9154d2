// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/feed/live_feed.h"

#include "core/signal/recording/units.h"

#include <utility>

namespace gripscope {

void LiveFeed::open(const ConnectSession& connection, bool back)
{
    m_commanded.reset();
    m_returned = back;
    if (back)
        return;
    m_shift_s = 0;
    const GripperIdentity identity = connection.identity();
    m_history.reset(identity.sampleTime_s);
    m_estimate.reset(identity.sampleTime_s, identity.hold, connection.forceLag_s());
}

void LiveFeed::take(const std::vector<Sample>& samples, ConnectSession& connection)
{
    m_history.append(placed(samples), commandedForces(samples, connection));
    m_estimate.append(samples);
}

std::vector<Sample> LiveFeed::placed(std::vector<Sample> samples)
{
    const Clock::time_point now = Clock::now();
    if (m_returned && !samples.empty()) {
        const double away_s = std::chrono::duration<double>(now - m_newest).count();
        m_shift_s = m_history.newestTime_s() + away_s - samples.back().time_s;
        m_returned = false;
    }
    m_newest = now;
    for (Sample& sample : samples)
        sample.time_s += m_shift_s;
    return samples;
}

std::vector<std::optional<double>> LiveFeed::commandedForces(const std::vector<Sample>& samples,
                                                             ConnectSession& connection)
{
    const SafetyGate* gate = connection.gate();
    const std::optional<double> unit_N = newtonsPer(connection.identity().forceUnit);
    if (!gate || !unit_N)
        return {};
    std::vector<std::optional<double>> forces = m_commanded.follow(samples, gate->lastStarted());
    for (std::optional<double>& force : forces)
        if (force)
            *force /= *unit_N;
    return forces;
}

} // namespace gripscope
