// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/command_queue.h"

#include <algorithm>

namespace gripscope {

using namespace protocol;

bool CommandQueue::isStop(const Entry& entry)
{
    return std::holds_alternative<StopCommand>(entry.command.body);
}

bool CommandQueue::isUpload(const Entry& entry)
{
    return std::holds_alternative<UploadCommand>(entry.command.body);
}

CommandQueue::Clock::duration CommandQueue::patienceFor(const Entry& entry)
{
    return isStop(entry) ? stopPatience : patience;
}

int CommandQueue::attemptsFor(const Entry& entry)
{
    return isStop(entry) ? stopAttempts : attempts;
}

void CommandQueue::push(CommandBody body)
{
    m_entries.push_back({Command{++m_lastNumber, body}, {}, 0});
}

void CommandQueue::stop()
{
    // A stop that waits for its answer already is put out anew: it must reach the device after all that was
    // sent.
    m_entries.clear();
    push(StopCommand{});
}

bool CommandQueue::stopping() const
{
    return !m_entries.empty() && isStop(m_entries.front());
}

std::optional<Report> CommandQueue::next(Clock::time_point now)
{
    for (std::size_t i = 0; i < std::min(m_entries.size(), uploadWindow); ++i) {
        Entry& entry = m_entries[i];
        const bool mayRunAhead = isUpload(entry) && isUpload(m_entries.front());
        if (i > 0 && !mayRunAhead)
            break;
        const bool waiting = entry.timesSent > 0 && now < entry.sent + patienceFor(entry);
        if (waiting || entry.timesSent >= attemptsFor(entry))
            continue;
        entry.sent = now;
        ++(entry.timesSent++ == 0 ? m_sent : m_repeated);
        return encode(entry.command);
    }
    return std::nullopt;
}

CommandQueue::Clock::time_point CommandQueue::wakeAt() const
{
    Clock::time_point earliest = Clock::time_point::max();
    for (std::size_t i = 0; i < std::min(m_entries.size(), uploadWindow); ++i)
        if (m_entries[i].timesSent > 0)
            earliest = std::min(earliest, m_entries[i].sent + patienceFor(m_entries[i]));
    return earliest;
}

std::optional<CommandQueue::Outcome> CommandQueue::acknowledge(const Acknowledgement& answer)
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
        return entry.timesSent > 0 && entry.command.number == answer.commandNumber &&
               reportId(entry.command.body) == answer.command;
    });
    if (found == m_entries.end())
        return std::nullopt;
    Outcome outcome{found->command.body, answer.result, answer.detail};
    ++m_answered;
    m_refused += answer.result != CommandResult::Done && answer.result != CommandResult::Repeated ? 1 : 0;
    m_entries.erase(found);
    return outcome;
}

std::optional<CommandQueue::Outcome> CommandQueue::expired(Clock::time_point now)
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
        return entry.timesSent >= attemptsFor(entry) && now >= entry.sent + patienceFor(entry);
    });
    if (found == m_entries.end())
        return std::nullopt;
    Outcome outcome{found->command.body, std::nullopt, 0};
    ++m_unanswered;
    m_entries.erase(found);
    return outcome;
}

Report CommandQueue::heartbeat()
{
    ++m_heartbeats;
    return encode(Command{++m_lastNumber, HeartbeatCommand{}});
}

void CommandQueue::fill(LinkCounters& counters) const
{
    counters.commandsSent = m_sent;
    counters.commandsRepeated = m_repeated;
    counters.commandsAnswered = m_answered;
    counters.commandsRefused = m_refused;
    counters.commandsUnanswered = m_unanswered;
    counters.heartbeats = m_heartbeats;
}

} // namespace gripscope
