// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_firmware.h"

#include "core/session/device_button.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace protocol;

namespace {

constexpr std::uint64_t noSqueeze = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t noisePurpose = 2;
constexpr std::uint8_t samplesPerReport = 2; ///< one report a millisecond, as full-speed USB gives
constexpr double contact_m =
    0.012347; ///< where the finger touches the object; the encoder's zero is elsewhere
constexpr double positionRange_m = 0.05;

std::int32_t toCounts(double value, double perCount)
{
    return static_cast<std::int32_t>(std::lround(value / perCount));
}

} // namespace

VirtualFirmware::VirtualFirmware(VirtualFirmwareOptions options)
    : m_options(std::move(options)), m_maxForce(toCounts(maxForce_N, forcePerCount_N)),
      m_maxTravel(toCounts(maxTravel_m, positionPerCount_m)), m_noise(m_options.seed, noSqueeze, noisePurpose)
{
}

std::optional<Report> VirtualFirmware::feature(std::uint8_t reportId) const
{
    switch (static_cast<ReportId>(reportId)) {
    case ReportId::Identity: {
        const bool can = m_options.objectName.size() == 1;
        const QString name = can ? QStringLiteral("Virtual gripper, can %1").arg(m_options.objectName)
                                 : QStringLiteral("Virtual gripper");
        IdentityFeature identity;
        identity.serial = "VG-" + std::to_string(m_options.seed);
        identity.firmware = "virtual 1";
        identity.name = name.toStdString();
        return encode(identity);
    }
    case ReportId::Measurement: {
        MeasurementFeature measurement;
        measurement.positionUnit = m_options.millimetres ? PositionUnit::Millimetre : PositionUnit::Metre;
        measurement.forcePerCount = forcePerCount_N;
        measurement.positionPerCount = m_options.millimetres ? 1000 * positionPerCount_m : positionPerCount_m;
        measurement.sampleTime_s = sampleTime_s;
        measurement.commandable = true;
        measurement.watchdog_ms = watchdog_us / 1000;
        return encode(measurement);
    }
    case ReportId::Limits:
        return encode(LimitsFeature{toCounts(maxForce_N, forcePerCount_N),
                                    toCounts(maxTravel_m, positionPerCount_m), maxSamples});
    default:
        return std::nullopt;
    }
}

void VirtualFirmware::receive(ReportView bytes, std::uint64_t now_us)
{
    const Decoded<Command> command = decodeCommand(bytes);
    if (command) {
        if (m_armed || std::holds_alternative<ArmCommand>(command->body))
            m_heartbeat_us = now_us;
        acknowledge(command->number, reportId(command->body), execute(command->body));
        return;
    }
    // The CRC says that the bytes are what was sent, so the sender can be told; otherwise even the number is
    // in doubt.
    const bool intact =
        command.error() == DecodeError::UnknownReport || command.error() == DecodeError::BadField;
    if (!intact)
        return;
    const auto result =
        command.error() == DecodeError::BadField ? CommandResult::BadValue : CommandResult::UnknownCommand;
    acknowledge(static_cast<std::uint16_t>(bytes[2] | bytes[3] << 8), static_cast<ReportId>(bytes[0]),
                {result, 0});
}

VirtualFirmware::Answer VirtualFirmware::execute(const CommandBody& body)
{
    if (std::holds_alternative<ArmCommand>(body))
        return arm();
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

VirtualFirmware::Answer VirtualFirmware::arm()
{
    constexpr std::uint32_t faultCode = 1; // the one fault it can have
    if (m_faults.broken)
        return {CommandResult::Fault, faultCode};
    if (m_armed)
        return {CommandResult::Repeated, m_lastStarted};
    m_armed = true;
    m_latched = 0;
    return {CommandResult::Done, m_lastStarted};
}

VirtualFirmware::Answer VirtualFirmware::disarm()
{
    const bool nothingToDo = !m_armed && m_phase == Phase::Idle;
    halt(0);
    return {nothingToDo ? CommandResult::Repeated : CommandResult::Done, 0};
}

void VirtualFirmware::halt(std::uint16_t cause)
{
    flush(); // what was sampled before belongs to the state before
    m_armed = false;
    m_latched |= cause;
    if (m_phase == Phase::RestBefore || m_phase == Phase::Moving) {
        m_phase = Phase::RestAfter;
        m_phaseIndex = 0;
        m_excitation = ExcitationState::Stopped;
    } else if (m_excitation == ExcitationState::Loading) {
        m_excitation = ExcitationState::None;
        m_uploadedEnd = 0;
        std::fill(m_uploaded.begin(), m_uploaded.end(), false);
    }
}

VirtualFirmware::Answer VirtualFirmware::setLimits(const SetLimitsCommand& limits)
{
    if (busy() && !settling())
        return {CommandResult::Busy, 0};
    if (limits.maxForce <= 0 || limits.maxTravel <= 0)
        return {CommandResult::BadValue, 0};
    if (limits.maxForce > toCounts(maxForce_N, forcePerCount_N) ||
        limits.maxTravel > toCounts(maxTravel_m, positionPerCount_m))
        return {CommandResult::LimitExceeded, 0};
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
    if (busy() && !settling())
        return {CommandResult::Busy, 0};
    if (static_cast<std::int16_t>(chunk.excitationNumber - m_lastStarted) <= 0)
        return {CommandResult::Spent, m_lastStarted};
    if (chunk.offset >= maxSamples || chunk.offset + chunk.count > maxSamples)
        return {CommandResult::BadValue, chunk.offset};
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
    if (m_squeezes > 0 && order.excitationNumber == m_lastStarted)
        return {CommandResult::Repeated, 0};
    if (!m_armed)
        return {CommandResult::NotArmed, 0};
    if (busy() && !settling())
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
        return {CommandResult::BadValue, m_uploadedEnd};
    const std::vector<std::int32_t> forces(m_forces.begin(),
                                           m_forces.begin() + static_cast<std::ptrdiff_t>(order.samples));
    if (forcesCrc(forces) != order.forcesCrc)
        return {CommandResult::ChecksumDiffers, 0};
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
    if (early.excitationNumber != m_lastStarted || (m_phase != Phase::RestBefore && m_phase != Phase::Moving))
        return {CommandResult::Repeated, 0};
    flush(); // what was sampled before was sampled in motion
    m_phase = Phase::RestAfter;
    m_phaseIndex = 0;
    return {};
}

void VirtualFirmware::setFaults(const FirmwareFaults& faults)
{
    if (faults.broken && !m_faults.broken)
        halt(0);
    if (!faults.sensorStuck)
        m_stuckPosition.reset();
    if (faults.clock_s != m_faults.clock_s)
        flush(); // the samples of a report share one clock
    m_faults = faults;
}

void VirtualFirmware::beginSqueeze()
{
    flush();
    const MassDampingStiffness object = m_options.object.draw(m_options.seed, m_squeezes);
    m_noise = RandomStream(m_options.seed, m_squeezes, noisePurpose);
    ++m_squeezes;
    m_step = discretize(object, sampleTime_s, ForceHold::Zero);
    m_state.setZero();
    m_lastStarted = m_excitationNumber;
    m_excitation = ExcitationState::Running;
    m_phase = Phase::RestBefore;
    m_phaseIndex = 0;
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
    m_outbox.push_back(encode(message));
}

void VirtualFirmware::sample(std::uint64_t now_us)
{
    if (m_options.hasWatchdog && m_armed && now_us > m_heartbeat_us + watchdog_us)
        halt(StatusWatchdog);
    if (m_phase == Phase::Moving && m_state[0] > m_maxTravel * positionPerCount_m)
        halt(StatusTravelLimit);
    const double force_N = nextForce();
    put(read(force_N));
    m_state = (m_step.phi * m_state + m_step.gamma0 * force_N).eval();
    ++m_sampleCount;
    advancePhase();
}

double VirtualFirmware::nextForce()
{
    return m_phase == Phase::Moving ? m_forces[m_phaseIndex] * forcePerCount_N : 0.0;
}

void VirtualFirmware::advancePhase()
{
    if (m_phase == Phase::Idle)
        return;
    ++m_phaseIndex;
    if (m_phase == Phase::RestBefore && m_phaseIndex == restBeforeSamples) {
        m_phase = Phase::Moving;
        m_phaseIndex = 0;
    } else if (m_phase == Phase::Moving && m_phaseIndex == m_length) {
        m_phase = Phase::RestAfter;
        m_phaseIndex = 0;
    } else if (m_phase == Phase::RestAfter && m_phaseIndex == restAfterSamples) {
        m_phase = Phase::Idle;
        if (m_excitation == ExcitationState::Running)
            m_excitation = ExcitationState::Finished;
        flush(); // so that the last samples and the end are known though no further sample may follow
    }
}

std::uint16_t VirtualFirmware::status() const
{
    return static_cast<std::uint16_t>(
        m_latched | (m_armed ? StatusArmed : 0) | (m_phase == Phase::Moving ? StatusMoving : 0) |
        (m_faults.broken ? StatusFault : 0) | (m_faults.buttonDown ? statusButton : 0));
}

VirtualFirmware::Reading VirtualFirmware::read(double force_N)
{
    Reading reading;
    reading.status = status();
    double force = force_N + m_faults.load_N + m_options.forceNoise_N * m_noise.normal();
    if (m_faults.saturateForce_N && force > *m_faults.saturateForce_N) {
        force = *m_faults.saturateForce_N;
        reading.status |= StatusForceSaturated;
    }
    double position = contact_m + m_state[0] + m_options.positionNoise_m * m_noise.normal();
    if (position < 0 || position > positionRange_m) {
        position = std::clamp(position, 0.0, positionRange_m);
        reading.status |= StatusPositionSaturated;
    }
    reading.raw = {toCounts(force, forcePerCount_N), toCounts(position, positionPerCount_m)};
    if (m_faults.sensorStuck) {
        if (!m_stuckPosition)
            m_stuckPosition = reading.raw.position;
        reading.raw.position = *m_stuckPosition;
    }
    return reading;
}

void VirtualFirmware::put(const Reading& reading)
{
    if (m_pending.count > 0 && m_pending.status != reading.status)
        flush();
    if (m_pending.count == 0) {
        m_pending.status = reading.status;
        m_pending.firstSample = static_cast<std::uint32_t>(m_sampleCount);
        m_pending.timestamp_us = timestamp_us(m_sampleCount);
    }
    m_pending.samples[m_pending.count++] = reading.raw;
    // Full, but for the last report of an excitation, which waits to carry its end (advancePhase).
    const bool last = m_phase == Phase::RestAfter && m_phaseIndex + 1 == restAfterSamples;
    if (m_pending.count >= samplesPerReport && !last)
        flush();
}

void VirtualFirmware::flush()
{
    if (m_pending.count == 0)
        return;
    m_pending.reportSequence = m_reportSequence++;
    m_pending.excitation = m_excitation;
    m_pending.excitationNumber = m_excitationNumber;
    m_outbox.push_back(encode(m_pending));
    m_pending = {};
}

std::uint32_t VirtualFirmware::timestamp_us(std::uint64_t sample) const
{
    const auto shift_us = static_cast<std::int64_t>(std::llround(m_faults.clock_s * 1e6));
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(sample * 500) + shift_us);
}

} // namespace gripscope
