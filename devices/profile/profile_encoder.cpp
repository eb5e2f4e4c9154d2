// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/profile_encoder.h"

#include "core/signal/recording/units.h"

#include <cmath>

namespace gripscope {

namespace {

/// A whole number that comes round, as the field's counter or clock does.
double wrapped(std::uint64_t count, const ProfileField& field)
{
    return static_cast<double>(count & ((std::uint64_t(1) << field.width()) - 1));
}

} // namespace

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
