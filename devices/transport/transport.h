// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "devices/protocol/report.h"

#include <chrono>
#include <functional>
#include <memory>

namespace gripscope {

/// Moves whole reports to and from a gripper; knows nothing of what they mean.
///
/// open(), then feature(), come first and from one thread; then read() from one thread and write() from
/// another at the same time. close() comes from any thread, makes a waiting read() return soon, and is final.
class Transport {
public:
    enum class Outcome {
        Report,  ///< a report of `size` bytes
        Timeout, ///< nothing came in time
        Lost,    ///< the device went away
        Ended,   ///< a replay is through
    };
    struct ReadResult {
        Outcome outcome = Outcome::Timeout;
        std::size_t size = 0;
    };
    using Buffer =
        std::array<std::uint8_t, 2 * protocol::reportSize>; ///< longer than a report, to notice long ones

    virtual ~Transport() = default;

    /// DeviceNotFound, DeviceAmbiguous, DevicePermission, FileUnreadable, BadInput. May take seconds.
    [[nodiscard]] virtual Expected<void> open() = 0;
    /// A feature report. May take seconds (a device that does not answer blocks for 5 s). DeviceLost,
    /// DeviceTimeout.
    [[nodiscard]] virtual Expected<protocol::Report> feature(protocol::ReportId id) = 0;
    [[nodiscard]] virtual ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) = 0;
    /// False: not taken; the device is gone or does not take reports now.
    [[nodiscard]] virtual bool write(const protocol::Report& report) = 0;
    virtual void close() noexcept = 0;
    /// If the program crashes while this transport is open, this is written to the device, where that can be.
    virtual void writeOnCrash(const protocol::Report&) {}

    /// What was opened, when the address left that open; empty texts where there is nothing to add.
    struct Place {
        QString address; ///< that means this device and no other
        QString port;    ///< where it is plugged in
    };
    [[nodiscard]] virtual Place place() const { return {}; }

    /// Reports come all the time, so that a second of silence means that something is wrong.
    [[nodiscard]] virtual bool streamsAlways() const { return true; }
    /// The device's time runs beside the computer's, so that its clock can be held against it; never by the
    /// device's own word.
    [[nodiscard]] virtual bool keepsComputerTime() const { return streamsAlways(); }
    /// Reports that are not read now are read later: nothing gets lost by waiting (a replay as fast as it
    /// can).
    [[nodiscard]] virtual bool waitsForReader() const { return false; }
    /// Commands can be written.
    [[nodiscard]] virtual bool takesCommands() const { return true; }

    /// What the program does, kept beside the reports where they are kept. From any thread, once opened.
    virtual void note(const QString&) {}
    /// The name under which the reports of this session are kept; empty where they are not.
    [[nodiscard]] virtual QString keptSession() const { return {}; }
};

using TransportMaker = std::function<std::shared_ptr<Transport>()>;

} // namespace gripscope
