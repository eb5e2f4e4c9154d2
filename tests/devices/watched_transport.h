// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/acquisition/device_port.h"
#include "devices/protocol/codec.h"
#include "devices/virtual/virtual_transport.h"
#include "tests/devices/port_helpers.h"

#include <atomic>

namespace gripscope::test {

/// A virtual gripper whose wire can be watched and held up.
class WatchedTransport : public Transport {
public:
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
            stopWritten = std::chrono::steady_clock::now().time_since_epoch().count();
        if (id == protocol::ReportId::Heartbeat)
            ++heartbeats;
        std::this_thread::sleep_for(writeTakes.load());
        if (ignoring.load() == id)
            return true;
        return m_inner->write(report);
    }
    void close() noexcept override { m_inner->close(); }
    bool streamsAlways() const override { return m_inner->streamsAlways(); }

    std::chrono::milliseconds openTakes{0};
    std::atomic<std::chrono::milliseconds> featureTakes{std::chrono::milliseconds(0)};
    std::atomic<std::chrono::milliseconds> readTakes{std::chrono::milliseconds(0)};
    std::atomic<std::chrono::milliseconds> writeTakes{std::chrono::milliseconds(0)};
    std::atomic<protocol::ReportId> ignoring{protocol::ReportId::Stream}; ///< no command: nothing is ignored
    std::atomic<std::int64_t> stopWritten{0};
    std::atomic<int> heartbeats{0};

private:
    std::shared_ptr<VirtualTransport> m_inner;
};

struct Watched : OpenPort {
    explicit Watched(std::shared_ptr<WatchedTransport> made)
        : OpenPort(std::make_unique<DevicePort>(u"virtual:"_qs, [made] { return made; })),
          wire(std::move(made))
    {
    }
    static std::shared_ptr<WatchedTransport> transport(double speed)
    {
        VirtualAddress address;
        address.speed = speed;
        return std::make_shared<WatchedTransport>(address);
    }
    std::shared_ptr<WatchedTransport> wire;
};

} // namespace gripscope::test
