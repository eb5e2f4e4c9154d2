// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/words.h"
#include "devices/transport.h"

namespace gripscope {

/// Another transport, of which only the reading end is let through: whatever is asked of this one, nothing
/// goes to the device. For grippers that are known by a profile, which would not understand what is written
/// and might move.
class ListeningTransport : public Transport {
public:
    explicit ListeningTransport(std::shared_ptr<Transport> inner) : m_inner(std::move(inner)) {}

    Expected<void> open() override { return m_inner->open(); }
    Expected<protocol::Report> feature(protocol::ReportId) override
    {
        return failure(ErrorCode::DeviceRefused,
                       {Words::tr("be asked"), Words::tr("it is known by a profile, and only "
                                                         "listened to")});
    }
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override
    {
        return m_inner->read(buffer, timeout);
    }
    bool write(const protocol::Report&) override { return false; }
    void close() noexcept override { m_inner->close(); }
    [[nodiscard]] Place place() const override { return m_inner->place(); }
    [[nodiscard]] bool streamsAlways() const override { return m_inner->streamsAlways(); }
    [[nodiscard]] bool takesCommands() const override { return false; }

private:
    const std::shared_ptr<Transport> m_inner;
};

} // namespace gripscope
