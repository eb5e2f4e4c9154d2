// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_firmware.h"

#include "core/session/connection/device_button.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace protocol;

namespace {

constexpr std::uint64_t noSqueeze = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t noisePurpose = 2, jitterPurpose = 3;
constexpr double report_s = 0.001; ///< one report a millisecond, as full-speed USB gives
constexpr double contact_m =
    0.012347; ///< where the finger touches the object; the encoder's zero is elsewhere
constexpr double positionRange_m = 0.05;

std::uint64_t noiseSeedOf(const VirtualFirmwareOptions& options)
{
    return options.noiseSeed.value_or(options.seed);
}

std::int32_t toCounts(double value, double perCount)
{
    return static_cast<std::int32_t>(std::lround(value / perCount));
}

/// Measured, not commanded: so far above the limit that no noise of the sensor stops a squeeze.
std::int64_t protectiveForce(std::int32_t limit)
{
    return std::int64_t(limit) + limit / 20 + VirtualFirmware::ownForce / 100;
}

} // namespace

VirtualFirmware::VirtualFirmware(VirtualFirmwareOptions options)
    : m_options(std::move(options)), m_maxForce(ownForce), m_maxTravel(ownTravel),
      m_noise(noiseSeedOf(m_options), noSqueeze, noisePurpose),
      m_jitter(noiseSeedOf(m_options), noSqueeze, jitterPurpose)
{
}

std::uint32_t VirtualFirmware::samplesIn(double seconds) const
{
    return static_cast<std::uint32_t>(std::max(1.0, std::round(seconds / sampleTime_s())));
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
        return sealed(encode(identity));
    }
    case ReportId::Measurement: {
        MeasurementFeature measurement;
        measurement.positionUnit = m_options.millimetres ? PositionUnit::Millimetre : PositionUnit::Metre;
        measurement.forcePerCount = forcePerCount_N;
        measurement.positionPerCount = m_options.millimetres ? 1000 * positionPerCount_m : positionPerCount_m;
        measurement.sampleTime_s = sampleTime_s();
        measurement.commandable = true;
        measurement.watchdog_ms = m_options.watchdog_ms;
        return sealed(encode(measurement));
    }
    case ReportId::Limits:
        return sealed(encode(LimitsFeature{ownForce, ownTravel, maxSamples}));
    default:
        return std::nullopt;
    }
}

Report VirtualFirmware::sealed(Report report) const
{
    seal(report, m_options.protocolMinor);
    return report;
}

void VirtualFirmware::watch(std::uint64_t now_us)
{
    const std::uint64_t waits_ms = m_options.watchdog_ms + (m_tripped ? m_options.patience_ms : 0U);
    if (m_options.hasWatchdog && !m_faults.noWatchdog && m_armed && m_options.watchdog_ms > 0 &&
        now_us > m_fed_us + 1000 * waits_ms) {
        m_tripped = true;
        halt(StatusWatchdog);
    }
}

void VirtualFirmware::halt(std::uint16_t cause)
{
    flush(); // what was sampled before belongs to the state before
    m_armed = false;
    m_latched |= cause;
    if (restsOrMoves()) {
        m_phase = Phase::RestAfter;
        m_phaseIndex = 0;
    }
    if (running()) {
        m_excitation = ExcitationState::Stopped;
    } else if (m_excitation == ExcitationState::Loading) {
        m_excitation = ExcitationState::None;
        m_excitationNumber = 0;
        m_uploadedEnd = 0;
        std::fill(m_uploaded.begin(), m_uploaded.end(), false);
    }
}

void VirtualFirmware::setFaults(const FirmwareFaults& faults)
{
    if (faults.broken && !m_faults.broken) {
        halt(0);
        m_faultShownUntil = m_sampleCount + samplesIn(faultShown_s);
    }
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
    m_noise = RandomStream(noiseSeedOf(m_options), m_squeezes, noisePurpose);
    m_jitter = RandomStream(noiseSeedOf(m_options), m_squeezes, jitterPurpose);
    ++m_squeezes;
    m_part = VirtualPart(object, m_options.terms, sampleTime_s() / (1 + m_faults.clockRate));
    m_before = m_part;
    m_forceBefore_N = 0;
    m_lastStarted = m_excitationNumber;
    m_anyStarted = true;
    m_excitation = ExcitationState::Running;
    m_phase = Phase::RestBefore;
    m_phaseIndex = 0;
}

void VirtualFirmware::sample(std::uint64_t now_us)
{
    watch(now_us);
    const double force_N = nextForce();
    const Reading reading = read(force_N);
    put(reading);
    protect(reading.raw);
    if (m_options.jitter_s > 0) {
        m_before = m_part;
        m_forceBefore_N = force_N;
    }
    m_part.advance(force_N);
    ++m_sampleCount;
    advancePhase();
}

void VirtualFirmware::protect(const RawSample& measured)
{
    if (!m_armed)
        return;
    const bool moving = m_phase == Phase::Moving;
    if (moving && m_phaseIndex == 0)
        m_travelFrom = measured.position;
    const auto travel = std::int64_t(measured.position) - m_travelFrom;
    m_forceBeyond = measured.force > protectiveForce(m_maxForce) ? m_forceBeyond + 1 : 0;
    m_travelBeyond = moving && travel > m_maxTravel ? m_travelBeyond + 1 : 0;
    if (m_forceBeyond >= samplesBeyond)
        halt(StatusForceLimit);
    else if (m_travelBeyond >= samplesBeyond)
        halt(StatusTravelLimit);
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
    if (m_phase == Phase::RestBefore && m_phaseIndex == samplesIn(restBefore_s)) {
        m_phase = Phase::Moving;
        m_phaseIndex = 0;
    } else if (m_phase == Phase::Moving && m_phaseIndex == m_length) {
        m_phase = Phase::RestAfter;
        m_phaseIndex = 0;
    } else if (m_phase == Phase::RestAfter && m_phaseIndex == samplesIn(restAfter_s)) {
        m_phase = Phase::Idle;
        if (running())
            m_excitation = ExcitationState::Finished;
        flush(); // so that the last samples and the end are known though no further sample may follow
    }
}

std::uint16_t VirtualFirmware::status() const
{
    return static_cast<std::uint16_t>(
        m_latched | (m_armed ? StatusArmed : 0) | (m_phase == Phase::Moving ? StatusMoving : 0) |
        (faultShown() ? StatusFault : 0) | (m_faults.buttonDown ? statusButton : 0));
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
    double position = contact_m + positionTaken(force_N) + m_options.positionNoise_m * m_noise.normal();
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

/// At the time that the sample says, or about it: evenly spread, so that no position is taken out of turn.
double VirtualFirmware::positionTaken(double force_N)
{
    if (!(m_options.jitter_s > 0))
        return m_part.position_m();
    const double late_s = std::sqrt(3.0) * m_options.jitter_s * (2 * m_jitter.uniform() - 1);
    return late_s >= 0 ? m_part.positionAfter(late_s, force_N)
                       : m_before.positionAfter(sampleTime_s() + late_s, m_forceBefore_N);
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
    const bool last = m_phase == Phase::RestAfter && m_phaseIndex + 1 == samplesIn(restAfter_s);
    if (m_pending.count >= samplesIn(report_s) && !last)
        flush();
}

void VirtualFirmware::flush()
{
    if (m_pending.count == 0)
        return;
    m_pending.reportSequence = m_reportSequence++;
    m_pending.excitation = m_excitation;
    m_pending.excitationNumber = m_excitationNumber;
    m_outbox.push_back(sealed(encode(m_pending)));
    m_pending = {};
}

std::uint32_t VirtualFirmware::timestamp_us(std::uint64_t sample) const
{
    const auto shift_us = static_cast<std::int64_t>(std::llround(m_faults.clock_s * 1e6));
    return static_cast<std::uint32_t>(std::llround(static_cast<double>(sample) * 1e6 * sampleTime_s()) +
                                      shift_us);
}

} // namespace gripscope
