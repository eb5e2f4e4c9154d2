// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/job_desk.h"

#include <algorithm>

namespace gripscope {

namespace {

/// More of them tell a person nothing new.
constexpr std::size_t mostRefusalsKept = 16;

std::uint16_t triggerBehind(std::uint16_t trigger)
{
    return trigger == 65535 ? 1 : static_cast<std::uint16_t>(trigger + 1); // 0 asks for nothing
}

} // namespace

bool JobDesk::plcAlive(TimePoint now) const
{
    return m_plcBeat && now - m_plcBeatAt <= m_heartbeatLimit;
}

void JobDesk::beat(std::uint16_t value, TimePoint now)
{
    if (m_plcBeat == value)
        return;
    m_plcBeat = value;
    m_plcBeatAt = now;
    m_heartbeatMissed = false;
}

bool JobDesk::takeLostHeartbeat(TimePoint now)
{
    if (m_heartbeatMissed || plcAlive(now))
        return false;
    m_heartbeatMissed = true;
    return true;
}

JobAnswer JobDesk::examine(const LineJob& job, TimePoint now) const
{
    if (m_job || m_station.state == LineState::SingleExecution)
        return JobAnswer::Busy;
    if (m_unread)
        return JobAnswer::ResultUnread;
    if (!plcAlive(now))
        return JobAnswer::HeartbeatMissing;
    if (m_station.state == LineState::Initialized ||
        (m_station.state == LineState::Ready && !m_station.armed))
        return JobAnswer::NotArmed;
    if (m_station.state != LineState::Ready)
        return JobAnswer::NotReady;
    return job.type > m_station.types ? JobAnswer::NoSuchType : JobAnswer::Taken;
}

void JobDesk::note(JobAnswer answer, const LineJob& job)
{
    m_refusals.push_back({answer, job});
    if (m_refusals.size() > mostRefusalsKept)
        m_refusals.pop_front();
}

JobAnswer JobDesk::startSingleJob(const LineJob& job, TimePoint now)
{
    if (job.trigger == 0)
        return JobAnswer::None;
    if (job == m_last)
        return m_lastAnswer;
    if (job.trigger != triggerBehind(m_last.trigger)) {
        if (job == m_lastOutOfStep)
            return JobAnswer::OutOfStep;
        m_lastOutOfStep = job;
        ++m_outOfStep;
        note(JobAnswer::OutOfStep, job);
        return JobAnswer::OutOfStep;
    }
    m_last = job;
    m_lastOutOfStep = {};
    m_lastAnswer = examine(job, now);
    if (m_lastAnswer == JobAnswer::Taken) {
        m_job = job;
        m_jobTold = false;
        return m_lastAnswer;
    }
    isOverrun(m_lastAnswer) ? ++m_overruns : ++m_refused;
    note(m_lastAnswer, job);
    return m_lastAnswer;
}

bool JobDesk::releaseResult(std::uint32_t sequence)
{
    if (!m_unread || m_results.empty() || m_results.back().sequence != sequence)
        return false;
    m_unread = false;
    return true;
}

std::optional<LineResult> JobDesk::resultById(std::uint32_t sequence) const
{
    const auto found = std::ranges::find(m_results, sequence, &LineResult::sequence);
    return found == m_results.end() ? std::nullopt : std::optional(*found);
}

std::optional<LineJob> JobDesk::takeJob()
{
    return m_job && !std::exchange(m_jobTold, true) ? m_job : std::nullopt;
}

void JobDesk::finish(LineResult result, TimePoint now)
{
    if (!m_job)
        return;
    result.sequence = ++m_sequence;
    result.job = *m_job;
    m_job.reset();
    m_results.push_back(std::move(result));
    if (m_results.size() > mostKept)
        m_results.pop_front();
    m_unread = true;
    m_unreadSince = now;
}

std::vector<JobDesk::Refusal> JobDesk::takeRefusals()
{
    std::vector<Refusal> taken(m_refusals.begin(), m_refusals.end());
    m_refusals.clear();
    return taken;
}

JobDesk::View JobDesk::view(TimePoint now) const
{
    View view;
    view.station = m_station;
    view.busy = m_job || m_station.state == LineState::SingleExecution;
    view.state = m_job ? LineState::SingleExecution : m_station.state;
    view.unread = m_unread;
    view.plcAlive = plcAlive(now);
    view.wouldTake = examine({}, now) == JobAnswer::Taken;
    view.stationBeat = m_stationBeat;
    view.lastTrigger = m_last.trigger;
    view.lastPartToken = m_last.partToken;
    view.lastAnswer = m_lastAnswer;
    view.overruns = m_overruns;
    view.refused = m_refused;
    view.outOfStep = m_outOfStep;
    view.run = m_run;
    if (!m_results.empty())
        view.result = m_results.back();
    if (m_unread)
        view.unreadSince = m_unreadSince;
    return view;
}

} // namespace gripscope
