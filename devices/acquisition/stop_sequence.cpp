// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/stop_sequence.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

void StopSequence::begin(const Begin& begin, Time now)
{
    m_begin = begin;
    m_began = now;
    m_firstSent.reset();
    m_obeyedAt.reset();
    m_heard = m_lastSent = {};
    m_sent = 0;
    m_armed = begin.armed;
    const bool nothingToRelax = !begin.samplesCome && begin.force <= begin.floor;
    m_relaxed = nothingToRelax || !begin.forceMatters ? samplesInRow : 0;
    judge(now);
}

bool StopSequence::engaged(Time now) const
{
    return m_began && (!allSent() || now < m_lastSent + m_begin.watchdog + m_limits.watchdogMargin);
}

std::optional<protocol::Report> StopSequence::next(Time now)
{
    if (!m_began || allSent() || (m_sent > 0 && now < m_lastSent + m_limits.stopSpacing))
        return std::nullopt;
    ++m_sent;
    m_lastSent = now;
    m_firstSent = m_firstSent.value_or(now);
    return m_begin.report;
}

StopSequence::Time StopSequence::wakeAt() const
{
    if (!m_began)
        return Time::max();
    if (m_sent == 0)
        return *m_began;
    return allSent() ? m_lastSent + m_begin.watchdog + m_limits.watchdogMargin
                     : m_lastSent + m_limits.stopSpacing;
}

void StopSequence::takeArmed(bool armed, Time now)
{
    m_armed = armed;
    judge(now);
}

void StopSequence::takeForce(double distanceFromRest, Time now)
{
    if (!m_begin.forceMatters)
        return;
    const double allowed = std::max(shareLeft * m_begin.force, m_begin.floor);
    m_relaxed = std::abs(distanceFromRest) <= allowed ? std::min(m_relaxed + 1, samplesInRow) : 0;
    judge(now);
}

void StopSequence::judge(Time now)
{
    if (!m_began || m_heard > deadline())
        return; // what comes now came too late
    if (m_armed || m_relaxed < samplesInRow)
        m_obeyedAt.reset();
    else if (!m_obeyedAt)
        m_obeyedAt = now;
}

StopSequence::Time StopSequence::deadline() const
{
    const Time latest = *m_began + m_limits.writerMayWait;
    return std::min(m_firstSent.value_or(latest), latest) + m_limits.obeyWithin;
}

void StopSequence::heard(Time time)
{
    m_heard = std::max(m_heard, time);
}

StopState StopSequence::state(Time now) const
{
    if (!m_began)
        return StopState::None;
    if (m_obeyedAt)
        return StopState::Obeyed;
    const bool late = m_heard > deadline() || now > deadline() + m_limits.deafReaderLimit;
    return late ? StopState::NotObeyed : StopState::Waiting;
}

} // namespace gripscope
