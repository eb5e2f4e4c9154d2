// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_firmware.h"

#include <algorithm>

// What the virtual gripper does with each command, in the order of checks that devices/PROTOCOL.md states;
// the rest is in virtual_firmware.cpp.

namespace gripscope {

using namespace protocol;

void VirtualFirmware::receive(ReportView bytes, std::uint64_t now_us)
{
    watch(now_us);
    const Decoded<Command> command = decodeCommand(bytes);
    if (command) {
        const Answer answer = execute(command->body);
        if (feedsWatchdog(command->body, answer.result))
            m_fed_us = now_us;
        acknowledge(command->number, reportId(command->body), answer);
        return;
    }
    // The CRC says that the bytes are what was sent, so the sender can be told; otherwise even the number is
    // in doubt.
    const DecodeError::Kind problem = command.error().kind;
    if (problem != DecodeError::UnknownReport && problem != DecodeError::BadField)
        return;
    const auto result =
        problem == DecodeError::BadField ? CommandResult::BadValue : CommandResult::UnknownCommand;
    acknowledge(static_cast<std::uint16_t>(bytes[2] | bytes[3] << 8), static_cast<ReportId>(bytes[0]),
                {result, 0});
}

VirtualFirmware::Answer VirtualFirmware::execute(const CommandBody& body)
{
    if (const auto* wish = std::get_if<ArmCommand>(&body))
        return arm(*wish);
    if (std::holds_alternative<DisarmCommand>(body) || std::holds_alternative<StopCommand>(body))
        return disarm();
    if (const auto* limits = std::get_if<SetLimitsCommand>(&body))
        return setLimits(*limits);
    if (const auto* chunk = std::get_if<UploadCommand>(&body))
        return upload(*chunk);
    if (const auto* order = std::get_if<StartCommand>(&body))
        return start(*order);
    if (const auto* early = std::get_if<FinishCommand>(&body))
        return finish(*early);
    return {}; // Heartbeat: its arrival is all it says.
}

bool VirtualFirmware::feedsWatchdog(const CommandBody& body, CommandResult result)
{
    if (std::holds_alternative<StopCommand>(body) || std::holds_alternative<DisarmCommand>(body))
        return false;
    const bool repeated = result == CommandResult::Repeated && !std::holds_alternative<ArmCommand>(body);
    return result == CommandResult::Done || repeated;
}

VirtualFirmware::Answer VirtualFirmware::arm(const ArmCommand& command)
{
    constexpr std::uint32_t faultCode = 1; // the one fault it can have
    const std::uint32_t token = m_options.protocolMinor >= minorWithArmToken ? command.token : 0;
    // Before all else: whatever became of the gripper since, this wish to arm it was met once.
    if (token != 0 && token == m_lastToken)
        return {CommandResult::Repeated, m_lastStarted};
    if (faultShown())
        return {CommandResult::Fault, faultCode};
    if (token != 0)
        m_lastToken = token;
    if (m_armed)
        return {CommandResult::Repeated, m_lastStarted};
    m_armed = true;
    m_latched = 0;
    m_forceBeyond = 0;
    return {CommandResult::Done, m_lastStarted};
}

VirtualFirmware::Answer VirtualFirmware::disarm()
{
    const bool nothingToDo = !m_armed && m_excitation != ExcitationState::Loading;
    halt(0);
    return {nothingToDo ? CommandResult::Repeated : CommandResult::Done, 0};
}

VirtualFirmware::Answer VirtualFirmware::setLimits(const SetLimitsCommand& limits)
{
    if (limits.maxForce <= 0 || limits.maxTravel <= 0)
        return {CommandResult::BadValue, limits.maxForce <= 0 ? limitsDetailForce : limitsDetailTravel};
    if (restsOrMoves())
        return {CommandResult::Busy, 0};
    if (limits.maxForce > ownForce || limits.maxTravel > ownTravel)
        return {CommandResult::LimitExceeded,
                limits.maxForce > ownForce ? limitsDetailForce : limitsDetailTravel};
    m_maxForce = limits.maxForce;
    m_maxTravel = limits.maxTravel;
    return {};
}

VirtualFirmware::Answer VirtualFirmware::refuseForces(const std::int32_t* forces, std::size_t count,
                                                      std::uint32_t firstIndex) const
{
    for (std::size_t i = 0; i < count; ++i) {
        const auto index = static_cast<std::uint32_t>(firstIndex + i);
        if (forces[i] < 0)
            return {CommandResult::BadValue, index};
        if (forces[i] > m_maxForce)
            return {CommandResult::LimitExceeded, index};
    }
    return {};
}

VirtualFirmware::Answer VirtualFirmware::upload(const UploadCommand& chunk)
{
    if (restsOrMoves())
        return {CommandResult::Busy, 0};
    if (static_cast<std::int16_t>(chunk.excitationNumber - m_lastStarted) <= 0)
        return {CommandResult::Spent, m_lastStarted};
    if (chunk.offset >= maxSamples || chunk.offset + chunk.count > maxSamples)
        return {CommandResult::BadValue, std::max(chunk.offset, maxSamples)};
    // All of it is looked at before any of it is stored.
    const Answer refused = refuseForces(chunk.forces.data(), chunk.count, chunk.offset);
    if (refused.result != CommandResult::Done)
        return refused;
    if (m_excitation != ExcitationState::Loading || m_excitationNumber != chunk.excitationNumber) {
        m_excitation = ExcitationState::Loading;
        m_excitationNumber = chunk.excitationNumber;
        m_forces.assign(maxSamples, 0);
        m_uploaded.assign(maxSamples, false);
        m_uploadedEnd = 0;
    }
    for (std::uint32_t i = 0; i < chunk.count; ++i) {
        m_forces[chunk.offset + i] = chunk.forces[i];
        m_uploaded[chunk.offset + i] = true;
    }
    m_uploadedEnd = std::max(m_uploadedEnd, chunk.offset + chunk.count);
    return {};
}

VirtualFirmware::Answer VirtualFirmware::start(const StartCommand& order)
{
    if (m_anyStarted && order.excitationNumber == m_lastStarted)
        return {CommandResult::Repeated, 0};
    if (!m_armed)
        return {CommandResult::NotArmed, 0};
    if (restsOrMoves())
        return {CommandResult::Busy, 0};
    if (static_cast<std::int16_t>(order.excitationNumber - m_lastStarted) <= 0)
        return {CommandResult::Spent, m_lastStarted};
    if (order.samples == 0 || order.samples > maxSamples)
        return {CommandResult::BadValue, 0};
    if (m_excitation != ExcitationState::Loading || m_excitationNumber != order.excitationNumber)
        return {CommandResult::Incomplete, 0};
    const auto end = m_uploaded.begin() + static_cast<std::ptrdiff_t>(order.samples);
    const auto missing = std::find(m_uploaded.begin(), end, false);
    if (missing != end)
        return {CommandResult::Incomplete, static_cast<std::uint32_t>(missing - m_uploaded.begin())};
    if (m_uploadedEnd > order.samples)
        return {CommandResult::BadValue, m_uploadedEnd - 1};
    const std::vector<std::int32_t> forces(m_forces.begin(),
                                           m_forces.begin() + static_cast<std::ptrdiff_t>(order.samples));
    if (const std::uint16_t crc = forcesCrc(forces); crc != order.forcesCrc)
        return {CommandResult::ChecksumDiffers, crc};
    // The limits may have been lowered since the upload.
    const Answer refused = refuseForces(forces.data(), forces.size(), 0);
    if (refused.result != CommandResult::Done)
        return refused;
    m_length = order.samples;
    beginSqueeze();
    return {};
}

VirtualFirmware::Answer VirtualFirmware::finish(const FinishCommand& early)
{
    if (early.excitationNumber != m_lastStarted || !restsOrMoves())
        return {CommandResult::Repeated, 0};
    flush(); // what was sampled before was sampled in motion
    m_phase = Phase::RestAfter;
    m_phaseIndex = 0;
    return {};
}

void VirtualFirmware::acknowledge(std::uint16_t number, ReportId command, Answer answer)
{
    Acknowledgement message;
    message.status = status();
    message.commandNumber = number;
    message.command = command;
    message.result = answer.result;
    message.detail = answer.detail;
    message.timestamp_us = timestamp_us(m_sampleCount);
    message.excitation = m_excitation;
    message.excitationNumber = m_excitationNumber;
    m_outbox.push_back(sealed(encode(message)));
}

} // namespace gripscope
