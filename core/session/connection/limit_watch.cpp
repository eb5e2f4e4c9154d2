// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/limit_watch.h"

#include "core/base/words.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

Error stopped(MechanicalQuantity quantity, double measured, double limit)
{
    return {ErrorCode::Stopped,
            {Words::say("%1 was measured, above the limit of %2")
                 .arg(Finding::quantity(quantity, measured), Finding::quantity(quantity, limit))}};
}

} // namespace

double limitAbove(double largest_N, double noiseDeviation_N)
{
    return largest_N + std::max(0.1 * largest_N, 5 * noiseDeviation_N);
}

LimitWatch::LimitWatch(const JobLimits& limits, const GripperIdentity& identity, std::optional<double> start)
    : m_start(start)
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

void LimitWatch::take(const Sample& sample)
{
    if (m_exceeded)
        return;
    if (!m_start)
        m_start = sample.position;
    if (m_force.exceededBy(sample.force))
        m_exceeded =
            stopped(MechanicalQuantity::Force, std::abs(sample.force) * *m_force.perUnit, m_force.limit);
    const double travel = sample.position - *m_start;
    if (m_travel.exceededBy(travel))
        m_exceeded =
            stopped(MechanicalQuantity::Length, std::abs(travel) * *m_travel.perUnit, m_travel.limit);
}

} // namespace gripscope
