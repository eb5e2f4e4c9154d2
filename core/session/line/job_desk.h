// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/line_values.h"

#include <chrono>
#include <deque>
#include <mutex>
#include <utility>

namespace gripscope {

/// Where a PLC and a station hand jobs and results to one another: a pure state machine over values and
/// times, without a wire, a clock or a gripper. One job at a time, one unread result at a time.
///
/// A job has a number that the PLC counts: 1 to 65535, then 1 again. Only the number behind the last one that
/// was answered is a new job; the last one once more is the same write again and changes nothing; any other
/// is a late or lost write, OutOfStep, and changes nothing but a count. So no write that is lost, doubled or
/// late squeezes a part twice or under another part's token. What is answered is answered for good: a refused
/// job is asked for again by the next number.
///
/// A job that was taken gets a result, also when its squeeze fails. The result stays until it is released by
/// its sequence; until then the next job is refused as an overrun.
class JobDesk {
public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr std::size_t mostKept = 64; ///< results that resultById() knows

    /// `run`: tells one run of the station from another, since sequences begin anew.
    explicit JobDesk(std::uint32_t run = 0) : m_run(run) {}
    /// A PLC whose heartbeat did not change for so long is lost.
    void setHeartbeatLimit(std::chrono::milliseconds limit) { m_heartbeatLimit = limit; }

    // The PLC's side.
    JobAnswer startSingleJob(const LineJob& job, TimePoint now);
    /// True when it was the unread one; anything else (a late or doubled write) changes nothing.
    bool releaseResult(std::uint32_t sequence);
    void beat(std::uint16_t value, TimePoint now);
    [[nodiscard]] std::optional<LineResult> resultById(std::uint32_t sequence) const;

    // The station's side.
    struct Station {
        LineState state = LineState::Preoperational;
        bool armed = false, simulated = false;
        std::uint16_t types = 0; ///< numbers from 1 to this name a type
        friend bool operator==(const Station&, const Station&) = default;
    };
    void setStation(const Station& station) { m_station = station; }
    void stationBeats() { ++m_stationBeat; }
    /// The job that was taken; told once.
    [[nodiscard]] std::optional<LineJob> takeJob();
    /// Of that job. Sequence and job are filled in here.
    void finish(LineResult result, TimePoint now);
    /// The PLC's heartbeat was there and no longer is; told once.
    [[nodiscard]] bool takeLostHeartbeat(TimePoint now);

    struct Refusal {
        JobAnswer answer = JobAnswer::None;
        LineJob job;
    };
    /// Refused since the last call, the newest ones; bounded.
    [[nodiscard]] std::vector<Refusal> takeRefusals();

    /// All that is to be read of it, at one moment.
    struct View {
        Station station;
        LineState state = LineState::Preoperational; ///< the station's, or that of a job under way
        bool busy = false, unread = false, plcAlive = false;
        bool wouldTake = false; ///< a trigger with the next number, of a type there is
        std::uint16_t stationBeat = 0;
        std::uint16_t lastTrigger = 0;
        std::uint32_t lastPartToken = 0;
        JobAnswer lastAnswer = JobAnswer::None;
        std::uint32_t overruns = 0, refused = 0, outOfStep = 0, run = 0;
        std::optional<LineResult> result; ///< the unread one, else the last that was released
        std::optional<TimePoint> unreadSince;
    };
    [[nodiscard]] View view(TimePoint now) const;

private:
    [[nodiscard]] bool plcAlive(TimePoint now) const;
    [[nodiscard]] JobAnswer examine(const LineJob& job, TimePoint now) const;
    void note(JobAnswer answer, const LineJob& job);

    std::uint32_t m_run;
    std::chrono::milliseconds m_heartbeatLimit{2000};
    Station m_station;
    std::uint16_t m_stationBeat = 0;
    LineJob m_last;
    JobAnswer m_lastAnswer = JobAnswer::None;
    LineJob m_lastOutOfStep; ///< a PLC that writes in a cycle is told and counted once
    std::optional<LineJob> m_job;
    bool m_jobTold = false;
    std::uint32_t m_sequence = 0;
    std::deque<LineResult> m_results; ///< the newest last
    bool m_unread = false;
    TimePoint m_unreadSince;
    std::uint32_t m_overruns = 0, m_refused = 0, m_outOfStep = 0;
    std::deque<Refusal> m_refusals;
    std::optional<std::uint16_t> m_plcBeat;
    TimePoint m_plcBeatAt;
    bool m_heartbeatMissed = true; ///< or there was none yet
};

/// One desk between the thread of the wire and that of the session. Held for microseconds.
class SharedJobDesk {
public:
    explicit SharedJobDesk(std::uint32_t run) : m_desk(run) {}
    /// `work(desk)` while nobody else has it.
    template <typename Work>
    auto with(Work&& work)
    {
        const std::lock_guard lock(m_mutex);
        return std::forward<Work>(work)(m_desk);
    }

private:
    std::mutex m_mutex;
    JobDesk m_desk;
};

} // namespace gripscope
