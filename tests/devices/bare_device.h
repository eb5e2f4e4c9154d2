// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/virtual/virtual_firmware.h"

#include <algorithm>
#include <vector>

namespace gripscope::test {

/// The virtual firmware by its bytes alone, in a time that the test makes pass.
struct BareDevice {
    explicit BareDevice(const QString& object = QStringLiteral("A")) : BareDevice(options(object)) {}
    explicit BareDevice(VirtualFirmwareOptions made) : firmware(std::move(made)) {}

    static VirtualFirmwareOptions options(const QString& object)
    {
        VirtualFirmwareOptions out;
        out.object = VirtualObject::fromText(object).value();
        out.objectName = object;
        return out;
    }

    protocol::Acknowledgement send(const protocol::CommandBody& body)
    {
        return send(protocol::Command{++number, body});
    }
    protocol::Acknowledgement send(const protocol::Command& command)
    {
        firmware.receive(protocol::encode(command), now_us);
        for (const protocol::Report& report : firmware.outbox()) {
            const protocol::Decoded<protocol::InputMessage> message = protocol::decodeInput(report);
            if (const auto* samples = std::get_if<protocol::StreamReport>(&*message))
                stream.push_back(*samples);
        }
        const protocol::Acknowledgement answer =
            std::get<protocol::Acknowledgement>(*protocol::decodeInput(firmware.outbox().back()));
        firmware.outbox().clear();
        return answer;
    }

    /// Lets `samples` pass, with a heartbeat each 50 ms unless told otherwise.
    void run(std::size_t samples, bool heartbeats = true)
    {
        for (std::size_t i = 0; i < samples; ++i) {
            now_us += 500;
            firmware.sample(now_us);
            if (heartbeats && i % 100 == 0)
                send(protocol::HeartbeatCommand{});
        }
        for (const protocol::Report& report : firmware.outbox())
            stream.push_back(std::get<protocol::StreamReport>(*protocol::decodeInput(report)));
        firmware.outbox().clear();
    }

    protocol::CommandResult upload(const std::vector<std::int32_t>& forces, std::uint16_t excitation)
    {
        for (std::size_t first = 0; first < forces.size(); first += protocol::maxForcesPerUpload) {
            protocol::UploadCommand chunk;
            chunk.excitationNumber = excitation;
            chunk.offset = static_cast<std::uint32_t>(first);
            chunk.count =
                static_cast<std::uint8_t>(std::min(protocol::maxForcesPerUpload, forces.size() - first));
            std::copy_n(forces.begin() + static_cast<std::ptrdiff_t>(first), chunk.count,
                        chunk.forces.begin());
            if (const protocol::CommandResult result = send(chunk).result;
                result != protocol::CommandResult::Done)
                return result;
        }
        return protocol::CommandResult::Done;
    }
    protocol::CommandResult start(const std::vector<std::int32_t>& forces, std::uint16_t excitation)
    {
        return send(protocol::StartCommand{excitation, static_cast<std::uint32_t>(forces.size()),
                                           protocol::forcesCrc(forces)})
            .result;
    }

    /// Samples in which the force was on, by the sensor, which has 20 counts of noise.
    std::size_t pushedSamples() const
    {
        std::size_t count = 0;
        for (const protocol::StreamReport& report : stream)
            for (std::size_t i = 0; i < report.count; ++i)
                count += report.samples[i].force > 500 ? 1 : 0;
        return count;
    }
    std::uint16_t lastStatus() const { return stream.back().status; }

    VirtualFirmware firmware;
    std::vector<protocol::StreamReport> stream;
    std::uint64_t now_us = 0;
    std::uint16_t number = 0;
};

} // namespace gripscope::test
