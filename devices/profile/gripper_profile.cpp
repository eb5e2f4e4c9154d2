// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/gripper_profile.h"

#include "core/session/connection/device_button.h"

#include <array>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<std::pair<const char16_t*, std::uint16_t>, 7> flags{
    {{u"moving", StatusMoving},
     {u"force_limit", StatusForceLimit},
     {u"travel_limit", StatusTravelLimit},
     {u"force_saturated", StatusForceSaturated},
     {u"position_saturated", StatusPositionSaturated},
     {u"fault", StatusFault},
     {u"button", statusButton}}};

} // namespace

double ProfileTime::secondsPerCount() const
{
    if (unit == u"ns")
        return 1e-9 * scale;
    if (unit == u"us")
        return 1e-6 * scale;
    return unit == u"ms" ? 1e-3 * scale : scale;
}

bool GripperProfile::clockIsFine() const
{
    constexpr double longestTick = 0.5; // of a report's time
    return time && time->secondsPerCount() <= longestTick * reportTime_s();
}

LossEvidence GripperProfile::lossEvidence() const
{
    if (sequence)
        return LossEvidence::SequenceNumber;
    return clockIsFine() ? LossEvidence::Clock : LossEvidence::None;
}

QString GripperProfile::usbNumbers() const
{
    return u"%1:%2"_s.arg(vendor, 4, 16, QLatin1Char('0')).arg(product, 4, 16, QLatin1Char('0'));
}

std::vector<NamedField> fieldsOf(const GripperProfile& profile)
{
    std::vector<NamedField> fields{{u"force"_s, &profile.force.field, true},
                                   {u"position"_s, &profile.position.field, true}};
    if (profile.sequence)
        fields.push_back({u"sequence"_s, &profile.sequence->field, false});
    if (profile.time)
        fields.push_back({u"time"_s, &profile.time->field, false});
    if (profile.status)
        fields.push_back({u"status"_s, &profile.status->field, false});
    return fields;
}

QString flagName(std::uint16_t meaning)
{
    for (const auto& flag : flags)
        if (flag.second == meaning)
            return QString::fromUtf16(flag.first);
    return {};
}

std::uint16_t flagFromName(const QString& name)
{
    for (const auto& flag : flags)
        if (name == QStringView(flag.first))
            return flag.second;
    return 0;
}

QStringList flagNames()
{
    QStringList names;
    for (const auto& flag : flags)
        names << QString::fromUtf16(flag.first);
    return names;
}

} // namespace gripscope
