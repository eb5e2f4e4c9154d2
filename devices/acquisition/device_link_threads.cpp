// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/words.h"
#include "devices/acquisition/device_link.h"

#include <algorithm>

// What the opener, the reader and the writer of a link do; the rest is in device_link.cpp.

namespace gripscope {

using namespace protocol;
using namespace Qt::StringLiterals;

void DeviceLink::runOpener()
{
    Expected<DeviceDescription> device = m_transport->open().and_then(
        [&]() -> Expected<DeviceDescription> { return m_decoder->describe(*m_transport, m_address); });
    const Lock lock(m_mutex);
    if (!device)
        return lose(device.error());
    m_device = std::move(*device);
    const Transport::Place place = m_transport->place();
    if (!place.address.isEmpty())
        m_device.identity.address = place.address;
    m_device.identity.port = place.port;
    m_device.identity.keptSession = m_transport->keptSession();
    m_lastReport = Clock::now();
    setState(LinkState::Ready);
}

bool DeviceLink::waitUntilOpened()
{
    Lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_state != LinkState::Opening; });
    if (live())
        m_watch.begin(m_device.identity.sampleTime_s, m_transport->streamsAlways());
    return live();
}

void DeviceLink::runReader()
{
    if (!waitUntilOpened())
        return;
    Transport::Buffer buffer{};
    for (;;) {
        waitForRoom();
        const Transport::ReadResult result = m_transport->read(buffer, readTimeout);
        if (result.outcome == Transport::Outcome::Report)
            take(ReportView(buffer).first(std::min(result.size, buffer.size())));
        else if (result.outcome == Transport::Outcome::Timeout)
            m_watch.nothingCame(Clock::now());
        const Lock lock(m_mutex);
        if (result.outcome == Transport::Outcome::Lost)
            lose({ErrorCode::DeviceLost, {m_address, Words::tr("it was unplugged or switched off")}});
        else if (result.outcome == Transport::Outcome::Ended)
            endReplay();
        else if (result.outcome == Transport::Outcome::Timeout && silentFor(silenceLimit, Clock::now()))
            lose({ErrorCode::DeviceLost, {m_address, Words::tr("it sent nothing for a second")}});
        const bool closing = m_state == LinkState::Closing;
        if ((closing && result.outcome != Transport::Outcome::Report) || (!closing && !live()))
            return;
    }
}

void DeviceLink::waitForRoom()
{
    if (!m_transport->waitsForReader())
        return;
    constexpr std::size_t manyReports = 1024; // samples; more than any one report holds
    Lock lock(m_mutex);
    while (live() && m_samples.room() < manyReports)
        m_changed.wait_for(lock, std::chrono::milliseconds(1));
}

bool DeviceLink::silentFor(std::chrono::milliseconds limit, Clock::time_point now) const
{
    if (!live())
        return false;
    const bool nothingCame = m_transport->streamsAlways() && now - m_lastReport > limit;
    const bool nothingAnswered = m_unansweredSince && now - *m_unansweredSince > limit;
    return nothingCame || nothingAnswered;
}

void DeviceLink::take(ReportView bytes)
{
    m_watch.reportCame();
    m_batch.clear();
    const ReportDecoder::Taken taken = m_decoder->take(bytes, m_batch);
    if (std::holds_alternative<DecodeError>(taken)) {
        m_watch.reportWasBad();
        return;
    }
    if (const auto* answer = std::get_if<Acknowledgement>(&taken))
        return takeAcknowledgement(*answer);
    if (std::holds_alternative<ReportDecoder::Other>(taken))
        return; // no sign that the stream lives
    const Clock::time_point now = Clock::now();
    takeSamples(now);
    const Lock lock(m_mutex);
    m_lastReport = now;
    m_unansweredSince.reset();
    if (std::holds_alternative<ReportDecoder::Restarted>(taken))
        lose({ErrorCode::DeviceLost, {m_address, Words::tr("it restarted")}});
    else if (const auto* stream = std::get_if<ReportDecoder::Stream>(&taken))
        takeState(stream->state);
}

void DeviceLink::takeSamples(Clock::time_point now)
{
    m_watch.decoded(m_decoder->counts(), m_batch, now);
    if (m_batch.empty())
        return;
    m_newestArrival_ns.store(
        std::chrono::duration_cast<std::chrono::nanoseconds>(now.time_since_epoch()).count());
    const std::size_t pushed = m_samples.push(m_batch);
    m_droppedSamples.fetch_add(m_batch.size() - pushed, std::memory_order_relaxed);
}

void DeviceLink::takeState(const ReportDecoder::DeviceState& state)
{
    if (m_understandsCommands && !olderThanAnswer(state))
        follow(state.status, state.excitation, state.excitationNumber);
}

bool DeviceLink::olderThanAnswer(const ReportDecoder::DeviceState& state)
{
    if (m_lastAnswer_us && static_cast<std::int32_t>(state.timestamp_us - *m_lastAnswer_us) < 0)
        return true;
    m_lastAnswer_us.reset(); // so that it does not look new again when the device's clock has gone round
    return false;
}

void DeviceLink::takeAcknowledgement(const Acknowledgement& answer)
{
    const Lock lock(m_mutex);
    m_lastReport = Clock::now();
    m_unansweredSince.reset();
    if (const auto outcome = m_commands.acknowledge(answer)) {
        settle(*outcome);
        m_changed.notify_all();
    }
    m_lastAnswer_us = answer.timestamp_us;
    follow(answer.status, answer.excitation, answer.excitationNumber);
}

void DeviceLink::runWriter()
{
    Lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_state != LinkState::Opening; });
    while (live() || (m_state == LinkState::Closing && m_commands.stopping())) {
        const bool last = m_state == LinkState::Closing;
        const Clock::time_point now = Clock::now();
        if (const std::optional<Report> report = nextReport(now)) {
            if (!m_unansweredSince)
                m_unansweredSince = now;
            lock.unlock();
            const bool written = m_transport->write(*report);
            lock.lock();
            if (last)
                return;
            // A transport that does not take it now is asked again with the command's next attempt.
            if (!written)
                m_changed.wait_for(lock, std::chrono::milliseconds(1));
        } else if (const auto outcome = m_commands.expired(now)) {
            refuse(*outcome);
        } else {
            m_changed.wait_until(lock, writerWakesAt(now));
        }
    }
}

std::optional<Report> DeviceLink::nextReport(Clock::time_point now)
{
    if (!m_commands.stopping() && heartbeatDue(now)) {
        m_lastHeartbeat = now;
        return m_commands.heartbeat();
    }
    return m_commands.next(now);
}

bool DeviceLink::heartbeatDue(Clock::time_point now) const
{
    if (m_state != LinkState::Armed || now < m_lastHeartbeat + heartbeatPeriod)
        return false;
    const auto aliveAt = Clock::time_point(
        std::chrono::duration_cast<Clock::duration>(std::chrono::nanoseconds(m_aliveAt_ns.load())));
    return now - aliveAt < aliveFor;
}

DeviceLink::Clock::time_point DeviceLink::writerWakesAt(Clock::time_point now) const
{
    const Clock::time_point heartbeat = now + heartbeatPeriod;
    const Clock::time_point due = m_lastHeartbeat + heartbeatPeriod;
    return std::min(
        {heartbeat, m_state == LinkState::Armed && due > now ? due : heartbeat, m_commands.wakeAt()});
}

} // namespace gripscope
