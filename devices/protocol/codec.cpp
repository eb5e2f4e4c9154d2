// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/codec.h"

#include "devices/protocol/byte_order.h"

#include <algorithm>
#include <limits>

namespace gripscope::protocol {

namespace {

constexpr std::uint32_t armKey = 0x214D5241; ///< the bytes "ARM!": no slip of a bit arms a gripper
constexpr std::size_t samplesOffset = 20;
constexpr std::size_t forcesOffset = 12;

/// The first of some checks that failed, as the error of a decoder.
using Problem = std::optional<FieldProblem>;
std::optional<DecodeError> firstOf(std::initializer_list<Problem> checks)
{
    const auto failed = std::find_if(checks.begin(), checks.end(), [](const Problem& p) { return p; });
    return failed == checks.end() ? std::nullopt : std::optional(DecodeError::badField(**failed));
}

/// A number that names one of an enumeration whose last is `last`.
template <typename Enum>
Problem notNamed(Field field, std::uint8_t value, Enum last)
{
    return outside(field, value, 0, static_cast<std::uint8_t>(last));
}

Report blank(ReportId id)
{
    Report report{};
    report[0] = static_cast<std::uint8_t>(id);
    return report;
}

template <typename... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

void storeBody(Report& report, const CommandBody& body)
{
    std::visit(Overloaded{
                   [&](const ArmCommand& arm) {
                       store(report, 4, armKey);
                       store(report, 8, arm.token);
                   },
                   [&](const SetLimitsCommand& limits) {
                       store(report, 4, limits.maxForce);
                       store(report, 8, limits.maxTravel);
                   },
                   [&](const UploadCommand& upload) {
                       store(report, 4, upload.excitationNumber);
                       const std::size_t count = std::min<std::size_t>(upload.count, maxForcesPerUpload);
                       report[6] = static_cast<std::uint8_t>(count);
                       store(report, 8, upload.offset);
                       for (std::size_t i = 0; i < count; ++i)
                           store(report, forcesOffset + 4 * i, upload.forces[i]);
                   },
                   [&](const StartCommand& start) {
                       store(report, 4, start.excitationNumber);
                       store(report, 6, start.forcesCrc);
                       store(report, 8, start.samples);
                   },
                   [&](const FinishCommand& finish) { store(report, 4, finish.excitationNumber); },
                   [](const auto&) {},
               },
               body);
}

Decoded<InputMessage> decodeStream(ReportView bytes)
{
    StreamReport message;
    message.status = load<std::uint16_t>(bytes, 2);
    message.reportSequence = load<std::uint32_t>(bytes, 4);
    message.firstSample = load<std::uint32_t>(bytes, 8);
    message.timestamp_us = load<std::uint32_t>(bytes, 12);
    message.count = bytes[17];
    message.excitationNumber = load<std::uint16_t>(bytes, 18);
    if (const auto error = firstOf({notNamed(Field::ExcitationState, bytes[16], ExcitationState::Stopped),
                                    outside(Field::SampleCount, message.count, 0, maxSamplesPerReport)}))
        return tl::unexpected(*error);
    message.excitation = static_cast<ExcitationState>(bytes[16]);
    for (std::size_t i = 0; i < message.count; ++i) {
        message.samples[i].force = load<std::int32_t>(bytes, samplesOffset + 8 * i);
        message.samples[i].position = load<std::int32_t>(bytes, samplesOffset + 8 * i + 4);
    }
    return message;
}

Decoded<InputMessage> decodeAcknowledgement(ReportView bytes)
{
    if (const auto error = firstOf({notNamed(Field::Result, bytes[7], CommandResult::Fault),
                                    notNamed(Field::ExcitationState, bytes[16], ExcitationState::Stopped)}))
        return tl::unexpected(*error);
    Acknowledgement message;
    message.status = load<std::uint16_t>(bytes, 2);
    message.commandNumber = load<std::uint16_t>(bytes, 4);
    message.command = static_cast<ReportId>(bytes[6]);
    message.result = static_cast<CommandResult>(bytes[7]);
    message.detail = load<std::uint32_t>(bytes, 8);
    message.timestamp_us = load<std::uint32_t>(bytes, 12);
    message.excitation = static_cast<ExcitationState>(bytes[16]);
    message.excitationNumber = load<std::uint16_t>(bytes, 18);
    return message;
}

Decoded<CommandBody> decodeUpload(ReportView bytes)
{
    UploadCommand upload;
    upload.excitationNumber = load<std::uint16_t>(bytes, 4);
    upload.count = bytes[6];
    upload.offset = load<std::uint32_t>(bytes, 8);
    if (const auto problem = outside(Field::ForceCount, upload.count, 1, maxForcesPerUpload))
        return tl::unexpected(DecodeError::badField(*problem));
    for (std::size_t i = 0; i < upload.count; ++i)
        upload.forces[i] = load<std::int32_t>(bytes, forcesOffset + 4 * i);
    return upload;
}

Decoded<CommandBody> decodeBody(ReportView bytes)
{
    switch (static_cast<ReportId>(bytes[0])) {
    case ReportId::Arm:
        if (const auto problem = outside(Field::ArmKey, load<std::uint32_t>(bytes, 4), armKey, armKey))
            return tl::unexpected(DecodeError::badField(*problem));
        return ArmCommand{load<std::uint32_t>(bytes, 8)};
    case ReportId::Disarm:
        return DisarmCommand{};
    case ReportId::Stop:
        return StopCommand{};
    case ReportId::Heartbeat:
        return HeartbeatCommand{};
    case ReportId::SetLimits:
        return SetLimitsCommand{load<std::int32_t>(bytes, 4), load<std::int32_t>(bytes, 8)};
    case ReportId::Upload:
        return decodeUpload(bytes);
    case ReportId::Start:
        return StartCommand{load<std::uint16_t>(bytes, 4), load<std::uint32_t>(bytes, 8),
                            load<std::uint16_t>(bytes, 6)};
    case ReportId::Finish:
        return FinishCommand{load<std::uint16_t>(bytes, 4)};
    default:
        return tl::unexpected(DecodeError::unknownReport(bytes[0]));
    }
}

std::optional<DecodeError> checkFeature(ReportView bytes, ReportId id)
{
    if (const auto error = checkReport(bytes))
        return error;
    if (bytes[0] != static_cast<std::uint8_t>(id))
        return DecodeError::unknownReport(bytes[0]);
    return std::nullopt;
}

} // namespace

Report encode(const StreamReport& message)
{
    Report report = blank(ReportId::Stream);
    store(report, 2, message.status);
    store(report, 4, message.reportSequence);
    store(report, 8, message.firstSample);
    store(report, 12, message.timestamp_us);
    report[16] = static_cast<std::uint8_t>(message.excitation);
    const std::size_t count = std::min<std::size_t>(message.count, maxSamplesPerReport);
    report[17] = static_cast<std::uint8_t>(count);
    store(report, 18, message.excitationNumber);
    for (std::size_t i = 0; i < count; ++i) {
        store(report, samplesOffset + 8 * i, message.samples[i].force);
        store(report, samplesOffset + 8 * i + 4, message.samples[i].position);
    }
    seal(report);
    return report;
}

Report encode(const Acknowledgement& message)
{
    Report report = blank(ReportId::Acknowledgement);
    store(report, 2, message.status);
    store(report, 4, message.commandNumber);
    report[6] = static_cast<std::uint8_t>(message.command);
    report[7] = static_cast<std::uint8_t>(message.result);
    store(report, 8, message.detail);
    store(report, 12, message.timestamp_us);
    report[16] = static_cast<std::uint8_t>(message.excitation);
    store(report, 18, message.excitationNumber);
    seal(report);
    return report;
}

Report encode(const Command& message)
{
    Report report = blank(reportId(message.body));
    store(report, 2, message.number);
    storeBody(report, message.body);
    seal(report);
    return report;
}

Report encode(const IdentityFeature& message)
{
    Report report = blank(ReportId::Identity);
    storeText(report, 4, 24, message.serial);
    storeText(report, 28, 10, message.firmware);
    storeText(report, 38, 24, message.name);
    seal(report, message.protocolMinor);
    return report;
}

Report encode(const MeasurementFeature& message)
{
    Report report = blank(ReportId::Measurement);
    report[2] = static_cast<std::uint8_t>(message.forceUnit);
    report[3] = static_cast<std::uint8_t>(message.positionUnit);
    report[4] = message.hold == ForceHold::First ? 1 : 0;
    report[5] = message.commandable ? 1 : 0;
    store(report, 6, message.watchdog_ms);
    storeDouble(report, 8, message.forcePerCount);
    storeDouble(report, 16, message.positionPerCount);
    storeDouble(report, 24, message.sampleTime_s);
    storeDouble(report, 32, message.forceLag_s);
    seal(report);
    return report;
}

Report encode(const LimitsFeature& message)
{
    Report report = blank(ReportId::Limits);
    store(report, 4, message.maxForce);
    store(report, 8, message.maxTravel);
    store(report, 12, message.maxSamples);
    seal(report);
    return report;
}

Decoded<InputMessage> decodeInput(ReportView bytes)
{
    if (const auto error = checkReport(bytes))
        return tl::unexpected(*error);
    switch (static_cast<ReportId>(bytes[0])) {
    case ReportId::Stream:
        return decodeStream(bytes);
    case ReportId::Acknowledgement:
        return decodeAcknowledgement(bytes);
    default:
        return tl::unexpected(DecodeError::unknownReport(bytes[0]));
    }
}

Decoded<Command> decodeCommand(ReportView bytes)
{
    if (const auto error = checkReport(bytes))
        return tl::unexpected(*error);
    return decodeBody(bytes).map([&](const CommandBody& body) {
        return Command{load<std::uint16_t>(bytes, 2), body};
    });
}

Decoded<IdentityFeature> decodeIdentity(ReportView bytes)
{
    if (const auto error = checkFeature(bytes, ReportId::Identity))
        return tl::unexpected(*error);
    return IdentityFeature{loadText(bytes, 4, 24), loadText(bytes, 28, 10), loadText(bytes, 38, 24),
                           static_cast<std::uint8_t>(bytes[1] & 0x0F)};
}

Decoded<MeasurementFeature> decodeMeasurement(ReportView bytes)
{
    if (const auto error = checkFeature(bytes, ReportId::Measurement))
        return tl::unexpected(*error);
    MeasurementFeature message;
    message.watchdog_ms = load<std::uint16_t>(bytes, 6);
    message.forcePerCount = loadDouble(bytes, 8);
    message.positionPerCount = loadDouble(bytes, 16);
    message.sampleTime_s = loadDouble(bytes, 24);
    message.forceLag_s = loadDouble(bytes, 32);
    if (const auto error = firstOf(
            {notNamed(Field::ForceUnit, bytes[2], ForceUnit::Kilonewton),
             notNamed(Field::PositionUnit, bytes[3], PositionUnit::Micrometre),
             outside(Field::ForceBetweenSamples, bytes[4], 0, 1),
             outside(Field::TakesCommands, bytes[5], 0, 1),
             outside(Field::ForcePerCount, message.forcePerCount, leastPerCount, mostPerCount),
             outside(Field::PositionPerCount, message.positionPerCount, leastPerCount, mostPerCount),
             outside(Field::SampleTime, message.sampleTime_s, shortestSampleTime_s, longestSampleTime_s),
             outside(Field::Lag, message.forceLag_s, -longestLag_s, longestLag_s)}))
        return tl::unexpected(*error);
    message.forceUnit = static_cast<ForceUnit>(bytes[2]);
    message.positionUnit = static_cast<PositionUnit>(bytes[3]);
    message.hold = bytes[4] == 1 ? ForceHold::First : ForceHold::Zero;
    message.commandable = bytes[5] == 1;
    return message;
}

Decoded<LimitsFeature> decodeLimits(ReportView bytes)
{
    if (const auto error = checkFeature(bytes, ReportId::Limits))
        return tl::unexpected(*error);
    LimitsFeature message{load<std::int32_t>(bytes, 4), load<std::int32_t>(bytes, 8),
                          load<std::uint32_t>(bytes, 12)};
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    if (const auto error = firstOf({outside(Field::LargestForce, message.maxForce, 0, most),
                                    outside(Field::LongestTravel, message.maxTravel, 0, most)}))
        return tl::unexpected(*error);
    return message;
}

ReportId reportId(const CommandBody& body)
{
    constexpr std::array ids{ReportId::Arm,       ReportId::Disarm, ReportId::Stop,  ReportId::Heartbeat,
                             ReportId::SetLimits, ReportId::Upload, ReportId::Start, ReportId::Finish};
    static_assert(ids.size() == std::variant_size_v<CommandBody>);
    return ids[body.index()];
}

std::uint16_t forcesCrc(const std::vector<std::int32_t>& forces)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * forces.size());
    for (const std::int32_t force : forces)
        for (int shift = 0; shift < 32; shift += 8)
            bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(force) >> shift));
    return crc16(bytes);
}

} // namespace gripscope::protocol
