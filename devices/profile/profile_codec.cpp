// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/profile_codec.h"

#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/units.h"
#include "devices/profile/profile_note.h"

#include <cmath>

namespace gripscope {

namespace {

DeviceDescription descriptionOf(const ProfiledDevice& device, const QString& address)
{
    const GripperProfile& profile = device.profile;
    DeviceDescription description;
    GripperIdentity& identity = description.identity;
    identity.address = address;
    identity.serial = device.serial;
    identity.name = profile.name;
    identity.forceUnit = profile.force.unit;
    identity.positionUnit = profile.position.unit;
    identity.sampleTime_s = profile.sampleTime_s();
    identity.hold = profile.hold;
    identity.forceLag_s = profile.forceLag_s;
    identity.commandable = false;
    identity.lossVisible = profile.lossEvidence() != LossEvidence::None;
    return description;
}

/// A whole number that comes round, as the field's counter or clock does.
double wrapped(std::uint64_t count, const ProfileField& field)
{
    return static_cast<double>(count & ((std::uint64_t(1) << field.width()) - 1));
}

} // namespace

ProfileDecoder::ProfileDecoder(const GripperProfile& profile)
{
    use(profile);
}

void ProfileDecoder::use(const GripperProfile& profile)
{
    m_profile = profile;
    m_counter = std::make_unique<ProfileCounter>(profile);
    m_read.resize(profile.samples);
}

Expected<DeviceDescription> ProfileDecoder::describe(Transport& transport, const QString& address)
{
    return m_source().map([&](const ProfiledDevice& device) {
        use(device.profile);
        transport.note(toNote(device)); // what is kept of the session must be read the same way later
        return descriptionOf(device, address);
    });
}

std::uint16_t ProfileDecoder::statusOf(const GripperProfile& profile, protocol::ReportView report)
{
    if (!profile.status)
        return 0;
    const std::uint32_t bits = profile.status->field.count(report);
    unsigned status = 0;
    for (const ProfileFlag& flag : profile.status->flags)
        if (((bits >> flag.bit & 1U) != 0) == flag.whenSet)
            status |= flag.meaning;
    return static_cast<std::uint16_t>(status);
}

/// False: a number is none.
bool ProfileDecoder::readSamples(protocol::ReportView bytes)
{
    const std::uint16_t status = statusOf(m_profile, bytes);
    for (std::size_t i = 0; i < m_profile.samples; ++i) {
        const double force = m_profile.force.field.number(bytes, i * m_profile.stride);
        const double position = m_profile.position.field.number(bytes, i * m_profile.stride);
        Sample& sample = m_read[i];
        sample.force = m_profile.force.value(force);
        sample.position = m_profile.position.value(position);
        if (!isReading(sample.force) || !isReading(sample.position))
            return false;
        sample.status = status;
        if (m_profile.force.saturated(force))
            sample.status |= StatusForceSaturated;
        if (m_profile.position.saturated(position))
            sample.status |= StatusPositionSaturated;
    }
    return true;
}

ReportDecoder::Taken ProfileDecoder::take(protocol::ReportView bytes, std::vector<Sample>& samples)
{
    if (m_profile.reportId && (bytes.empty() || bytes[0] != *m_profile.reportId))
        return Other{};
    if (bytes.size() != m_profile.reportLength)
        return protocol::DecodeError::Length;
    if (!readSamples(bytes))
        return protocol::DecodeError::BadField;
    ProfileCounter::Place place;
    switch (m_counter->take(bytes, place)) {
    case ProfileCounter::Outcome::Duplicate:
        return Duplicate{};
    case ProfileCounter::Outcome::Restarted:
        return Restarted{};
    case ProfileCounter::Outcome::Inconsistent:
        return protocol::DecodeError::BadField;
    case ProfileCounter::Outcome::Accepted:
        break;
    }
    for (std::size_t i = 0; i < m_read.size(); ++i) {
        m_read[i].sequence = place.firstSample + i;
        m_read[i].time_s = place.time_s + static_cast<double>(i) * m_profile.sampleTime_s();
    }
    m_read.front().clockStepped = place.clockStepped;
    samples.insert(samples.end(), m_read.begin(), m_read.end());
    return Stream{{m_read.front().status, 0, protocol::ExcitationState::None, 0}};
}

ReportDecoder::Counts ProfileDecoder::counts() const
{
    return {m_counter->lostSamples(), m_counter->sequenceGaps(), m_counter->clockSteps(),
            m_counter->duplicateReports()};
}

ProfileEncoder::ProfileEncoder(const GripperProfile& profile)
    : m_profile(profile), m_newtons(newtonsPer(profile.force.unit).value_or(1)),
      m_metres(metresPer(profile.position.unit).value_or(1))
{
}

bool ProfileEncoder::put(const ProfileChannel& channel, double value_SI, double siPerUnit,
                         std::span<std::uint8_t> report, std::size_t shift) const
{
    const double number = (value_SI / siPerUnit - channel.offset) / channel.scale;
    const bool fits = channel.field.put(number, report, shift);
    return !fits || channel.saturated(channel.field.number(report, shift));
}

void ProfileEncoder::putStatus(std::uint16_t status, std::span<std::uint8_t> report) const
{
    std::uint32_t bits = 0;
    for (const ProfileFlag& flag : m_profile.status->flags)
        if (((status & flag.meaning) != 0) == flag.whenSet)
            bits |= 1U << flag.bit;
    static_cast<void>(m_profile.status->field.put(bits, report));
}

std::vector<std::uint8_t> ProfileEncoder::encode(std::span<const Reading> readings, double time_s)
{
    std::vector<std::uint8_t> report(m_profile.reportLength, 0);
    if (m_profile.reportId)
        report[0] = *m_profile.reportId;
    unsigned status = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const std::size_t shift = i * m_profile.stride;
        status |= readings[i].status;
        if (put(m_profile.force, readings[i].force_N, m_newtons, report, shift))
            status |= StatusForceSaturated;
        if (put(m_profile.position, readings[i].position_m, m_metres, report, shift))
            status |= StatusPositionSaturated;
    }
    if (const auto& sequence = m_profile.sequence) {
        const std::uint64_t count = sequence->countsSamples ? m_reports * m_profile.samples : m_reports;
        static_cast<void>(sequence->field.put(wrapped(count, sequence->field), report));
    }
    if (const auto& time = m_profile.time) {
        const auto ticks = static_cast<std::uint64_t>(std::llround(time_s / time->secondsPerCount()));
        static_cast<void>(time->field.put(wrapped(ticks, time->field), report));
    }
    if (m_profile.status)
        putStatus(static_cast<std::uint16_t>(status), report);
    ++m_reports;
    return report;
}

} // namespace gripscope
