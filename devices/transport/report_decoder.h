// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/codec.h"
#include "devices/transport/device_description.h"

#include <functional>
#include <memory>
#include <variant>
#include <vector>

namespace gripscope {

/// The language of a gripper: what the device is, and what its input reports say.
///
/// One for each connection: describe() first, from the thread that opens; from then on only the thread that
/// reads calls it.
class ReportDecoder {
public:
    /// What a stream report says of the device itself.
    struct DeviceState {
        std::uint16_t status = 0; ///< SampleStatus bits
        std::uint32_t timestamp_us = 0;
        protocol::ExcitationState excitation = protocol::ExcitationState::None;
        std::uint16_t excitationNumber = 0;
    };
    /// The report's samples were appended.
    struct Stream {
        DeviceState state;
    };
    struct Duplicate {}; ///< a report that came before
    struct Restarted {}; ///< the device has begun to count anew
    struct Other {};     ///< a report that is none of the stream's
    using Taken =
        std::variant<Stream, Duplicate, Restarted, Other, protocol::Acknowledgement, protocol::DecodeError>;

    struct Counts {
        std::uint64_t lostSamples = 0;
        std::uint64_t sequenceGaps = 0; ///< places where they are missing
        std::uint64_t clockSteps = 0;   ///< the device's clock jumped against its sample count
        std::uint64_t duplicateReports = 0;
    };

    virtual ~ReportDecoder() = default;
    /// Over an open transport. May take seconds.
    [[nodiscard]] virtual Expected<DeviceDescription> describe(Transport& transport,
                                                               const QString& address) = 0;
    /// One report as it came; its samples are appended to `samples`.
    [[nodiscard]] virtual Taken take(protocol::ReportView bytes, std::vector<Sample>& samples) = 0;
    [[nodiscard]] virtual Counts counts() const = 0;
    /// False: nothing is ever written to such a gripper, not even a stop, which it would not understand.
    [[nodiscard]] virtual bool understandsCommands() const = 0;
};

using DecoderMaker = std::function<std::unique_ptr<ReportDecoder>()>;

} // namespace gripscope
