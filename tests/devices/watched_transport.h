// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/acquisition/device_port.h"
#include "devices/protocol/codec.h"
#include "devices/virtual/virtual_transport.h"
#include "tests/devices/port_helpers.h"

#include <atomic>

namespace gripscope::test {

/// A virtual gripper whose wire can be watched and held up at any moment. What its faults can do (a call that
/// hangs, a command that does not arrive) is better said by a script.
class WatchedTransport : public Transport {
public:
    using Clock = std::chrono::steady_clock;
    explicit WatchedTransport(const VirtualAddress& address) : m_inner(*VirtualTransport::make(address)) {}

    Expected<void> open() override
    {
        std::this_thread::sleep_for(openTakes);
        return m_inner->open();
    }
    Expected<protocol::Report> feature(protocol::ReportId id) override
    {
        std::this_thread::sleep_for(featureTakes.load());
        return m_inner->feature(id);
    }
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override
    {
        std::this_thread::sleep_for(readTakes.load());
        return m_inner->read(buffer, timeout);
    }
    bool write(const protocol::Report& report) override
    {
        const auto id = static_cast<protocol::ReportId>(report[0]);
        if (id == protocol::ReportId::Stop)
            stopWritten = Clock::now().time_since_epoch().count();
        if (id == protocol::ReportId::Heartbeat)
            ++heartbeats;
        std::this_thread::sleep_for(writeTakes.load());
        return m_inner->write(report);
    }
    void close() noexcept override { m_inner->close(); }
    bool streamsAlways() const override { return m_inner->streamsAlways(); }
    bool keepsComputerTime() const override { return m_inner->keepsComputerTime(); }
    FaultCounts faultCounts() const { return m_inner->faultCounts(); }

    std::chrono::milliseconds openTakes{0};
    std::atomic<std::chrono::milliseconds> featureTakes{std::chrono::milliseconds(0)};
    std::atomic<std::chrono::milliseconds> readTakes{std::chrono::milliseconds(0)};
    std::atomic<std::chrono::milliseconds> writeTakes{std::chrono::milliseconds(0)};
    std::atomic<std::int64_t> stopWritten{0}; ///< when a stop was last handed over; 0: never
    std::atomic<int> heartbeats{0};

private:
    std::shared_ptr<VirtualTransport> m_inner;
};

/// A port on one.
struct Watched : OpenPort {
    explicit Watched(std::shared_ptr<WatchedTransport> made) : Watched(made, [made] { return made; }) {}
    /// `transport`: with something between it and the port.
    Watched(std::shared_ptr<WatchedTransport> made, const TransportMaker& transport)
        : OpenPort(std::make_unique<DevicePort>(QStringLiteral("virtual:"), transport)), wire(std::move(made))
    {
    }
    /// `faults`: lines of a script.
    static std::shared_ptr<WatchedTransport> transport(double speed, const QByteArray& faults = {})
    {
        VirtualAddress address;
        address.speed = speed;
        address.faults = parseFaultScript(faults, QStringLiteral("faults")).value();
        return std::make_shared<WatchedTransport>(address);
    }
    /// Armed, and in the midst of ten seconds of squeezing; begun anew where a busy computer kept the gripper
    /// waiting for so long that its watchdog ended it.
    bool squeezesForLong()
    {
        constexpr int mostTries = 20;
        const auto runs = [this] { return port->squeezeState() == SqueezeState::Running; };
        for (int tries = 0; tries < mostTries; ++tries) {
            if (arm() && gate.start(usualForce(20000)) &&
                pollUntil([&] { return runs() || squeezeIsOver(); }) && runs()) {
                wire->stopWritten = 0; // of a try before; its repeats are over, for it was armed since
                return true;
            }
            if (const auto error = port->lastError())
                qInfo("once more: %s", qPrintable(error->describe()));
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
        }
        return false;
    }
    std::shared_ptr<WatchedTransport> wire;
};

/// All status bits that any sample has.
inline std::uint16_t statusSeen(const std::vector<Sample>& samples)
{
    std::uint16_t seen = 0;
    for (const Sample& sample : samples)
        seen = static_cast<std::uint16_t>(seen | sample.status);
    return seen;
}

} // namespace gripscope::test
