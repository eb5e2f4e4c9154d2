// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/transport/device_description.h"

#include "core/base/words.h"
#include "core/signal/recording/units.h"
#include "devices/protocol/arming_obstacle.h"
#include "devices/protocol/codec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace protocol;
using namespace Qt::StringLiterals;

namespace {

QString unitName(ForceUnit unit)
{
    switch (unit) {
    case ForceUnit::None:
        break;
    case ForceUnit::Newton:
        return u"N"_qs;
    case ForceUnit::Millinewton:
        return u"mN"_qs;
    case ForceUnit::Kilonewton:
        return u"kN"_qs;
    }
    return u"1"_qs;
}

QString unitName(PositionUnit unit)
{
    switch (unit) {
    case PositionUnit::None:
        break;
    case PositionUnit::Metre:
        return u"m"_qs;
    case PositionUnit::Millimetre:
        return u"mm"_qs;
    case PositionUnit::Micrometre:
        return u"um"_qs;
    }
    return u"1"_qs;
}

template <typename Feature>
Expected<Feature> ask(Transport& transport, ReportId id, Decoded<Feature> (*decode)(ReportView))
{
    ASSIGN_OR_RETURN(const Report report, transport.feature(id));
    const Decoded<Feature> feature = decode(report);
    if (!feature)
        return failure(ErrorCode::DeviceRefused,
                       {Words::tr("say what it is"), Words::tr("feature report 0x%1: %2")
                                                         .arg(static_cast<int>(id), 2, 16, QLatin1Char('0'))
                                                         .arg(describe(feature.error()))});
    return *feature;
}

double countsIn(double value_SI, double siPerUnit, double unitsPerCount)
{
    return std::clamp(value_SI / siPerUnit / unitsPerCount, 0.0,
                      static_cast<double>(std::numeric_limits<std::int32_t>::max()));
}

} // namespace

std::int32_t DeviceDescription::forceCounts(double force_N) const
{
    const double newtons = newtonsPer(identity.forceUnit).value_or(1.0);
    return static_cast<std::int32_t>(std::lround(countsIn(force_N, newtons, measurement.forcePerCount)));
}

SetLimitsCommand DeviceDescription::limitCounts(double maxForce_N, double maxTravel_m) const
{
    const double newtons = newtonsPer(identity.forceUnit).value_or(1.0);
    const double metres = metresPer(identity.positionUnit).value_or(1.0);
    constexpr double slack =
        1e-6; // a limit of 30 N is 30000 counts, though the division may give 29999.999...
    const auto down = [](double counts) { return static_cast<std::int32_t>(std::floor(counts + slack)); };
    constexpr double most = std::numeric_limits<std::int32_t>::max() - 1.0;
    return {std::min(limits.maxForce,
                     down(std::min(most, countsIn(maxForce_N, newtons, measurement.forcePerCount)))),
            std::min(limits.maxTravel,
                     down(std::min(most, countsIn(maxTravel_m, metres, measurement.positionPerCount))))};
}

Expected<DeviceDescription> describeDevice(Transport& transport, const QString& address)
{
    ASSIGN_OR_RETURN(const IdentityFeature identity, ask(transport, ReportId::Identity, &decodeIdentity));
    ASSIGN_OR_RETURN(const MeasurementFeature measurement,
                     ask(transport, ReportId::Measurement, &decodeMeasurement));
    ASSIGN_OR_RETURN(const LimitsFeature limits, ask(transport, ReportId::Limits, &decodeLimits));

    DeviceDescription description;
    description.measurement = measurement;
    description.limits = limits;
    GripperIdentity& out = description.identity;
    out.address = address;
    out.serial = QString::fromStdString(identity.serial);
    out.name = QString::fromStdString(identity.name);
    out.firmware = QString::fromStdString(identity.firmware);
    out.protocolMajor = versionMajor;
    out.protocolMinor = identity.protocolMinor;
    out.forceUnit = unitName(measurement.forceUnit);
    out.positionUnit = unitName(measurement.positionUnit);
    out.sampleTime_s = measurement.sampleTime_s;
    out.hold = measurement.hold;
    out.forceLag_s = measurement.forceLag_s;
    const std::optional<double> newtons = newtonsPer(out.forceUnit);
    const std::optional<double> metres = metresPer(out.positionUnit);
    out.limits.maxForce_N = limits.maxForce * measurement.forcePerCount * newtons.value_or(0.0);
    out.limits.maxTravel_m = limits.maxTravel * measurement.positionPerCount * metres.value_or(0.0);
    out.limits.maxSamples = limits.maxSamples;
    if (const auto problem = armingObstacle(measurement, limits))
        description.armingObstacle = describeObstacle(*problem);
    out.commandable = measurement.commandable && transport.takesCommands() && newtons && metres;
    return description;
}

} // namespace gripscope
