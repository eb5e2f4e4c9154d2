// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/command_queue.h"

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace protocol;

bool CommandQueue::isArm(const Entry& entry)
{
    return std::holds_alternative<ArmCommand>(entry.command.body);
}

bool CommandQueue::isUpload(const Entry& entry)
{
    return std::holds_alternative<UploadCommand>(entry.command.body);
}

CommandQueue::Clock::duration CommandQueue::patienceFor(const Entry& entry)
{
    return isArm(entry) ? armPatience : patience;
}

int CommandQueue::attemptsFor(const Entry& entry) const
{
    return isArm(entry) && !m_repeatsArm ? 1 : m_attempts;
}

Command CommandQueue::number(CommandBody body)
{
    ++m_lastNumber;
    m_numbered[m_lastNumber % m_numbered.size()] = reportId(body);
    m_numberedCount = std::min(m_numberedCount + 1, m_numbered.size());
    return {m_lastNumber, body};
}

bool CommandQueue::sentHere(const Acknowledgement& answer) const
{
    const auto age = static_cast<std::uint16_t>(m_lastNumber - answer.commandNumber);
    return age < m_numberedCount && m_numbered[answer.commandNumber % m_numbered.size()] == answer.command;
}

void CommandQueue::push(CommandBody body)
{
    m_entries.push_back({{0, body}, {}, 0}); // numbered when it is sent
}

Report CommandQueue::halt(CommandBody body)
{
    m_entries.clear();
    m_halt = number(body);
    return encode(*m_halt);
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
        if (entry.timesSent == 0)
            entry.command = number(entry.command.body);
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
    if (m_halt && m_halt->number == answer.commandNumber && reportId(m_halt->body) == answer.command) {
        ++m_answered;
        return Outcome{std::exchange(m_halt, std::nullopt)->body, answer.result, answer.detail};
    }
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
    Outcome outcome{found->command.body, std::nullopt, 0, found->timesSent * patienceFor(*found)};
    ++m_unanswered;
    m_entries.erase(found);
    return outcome;
}

Report CommandQueue::heartbeat()
{
    ++m_heartbeats;
    return encode(number(HeartbeatCommand{}));
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
