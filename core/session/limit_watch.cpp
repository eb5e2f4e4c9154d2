// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/limit_watch.h"

#include "core/signal/units.h"
#include "core/words.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString text(double value, const QString& unit)
{
    return u"%L1 %2"_qs.arg(value, 0, 'g', 4).arg(unit);
}

Error stopped(const QString& measured, const QString& limit)
{
    return {ErrorCode::DeviceRefused,
            {Words::tr("go on with the squeeze"),
             Words::tr("%1 is measured, above the limit of %2").arg(measured, limit)}};
}

} // namespace

LimitWatch::LimitWatch(const JobLimits& limits, const GripperIdentity& identity)
{
    m_force.perUnit = newtonsPer(identity.forceUnit);
    m_force.limit = limits.maxForce_N;
    m_travel.perUnit = metresPer(identity.positionUnit);
    m_travel.limit = limits.maxTravel_m;
}

bool LimitWatch::Channel::exceededBy(double value)
{
    if (!perUnit)
        return false;
    above = std::abs(value) * *perUnit > (1 + allowance) * limit ? above + 1 : 0;
    return above >= samplesInRow;
}

void LimitWatch::take(const std::vector<Sample>& samples)
{
    for (const Sample& sample : samples)
        if (!m_exceeded && (sample.status & StatusMoving))
            take(sample);
}

void LimitWatch::take(const Sample& sample)
{
    if (!m_start)
        m_start = sample.position;
    if (m_force.exceededBy(sample.force))
        m_exceeded =
            stopped(text(std::abs(sample.force) * *m_force.perUnit, u"N"_qs), text(m_force.limit, u"N"_qs));
    const double travel = sample.position - *m_start;
    if (m_travel.exceededBy(travel))
        m_exceeded = stopped(text(1e3 * std::abs(travel) * *m_travel.perUnit, u"mm"_qs),
                             text(1e3 * m_travel.limit, u"mm"_qs));
}

} // namespace gripscope
