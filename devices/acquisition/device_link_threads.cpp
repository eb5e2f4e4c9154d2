// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/acquisition/device_link.h"
#include "devices/transport/crash_stop.h"

#include <QRandomGenerator>

#include <algorithm>

// What the opener, the reader and the writer of a link do; the rest is in device_link.cpp.

namespace gripscope {

using namespace protocol;
using namespace Qt::StringLiterals;

namespace {

/// A call of read() that took longer had to wait: nothing was there when it began.
constexpr std::chrono::microseconds hadToWait{200};

LinkControl::Options controlOptions(const LinkLimits& limits, bool realTime)
{
    LinkControl::Options options;
    options.limits = limits;
    options.realTime = realTime;
    if (realTime) { // else the same run gives the same bytes
        options.lastNumber = static_cast<std::uint16_t>(QRandomGenerator::global()->generate());
        options.lastToken = QRandomGenerator::global()->generate();
    }
    return options;
}

} // namespace

void DeviceLink::runOpener()
{
    Expected<DeviceDescription> device = m_transport->open().and_then(
        [&]() -> Expected<DeviceDescription> { return m_decoder->describe(*m_transport, m_address); });
    const Lock lock(m_mutex);
    if (!device)
        return lose(device.error());
    const Transport::Place place = m_transport->place();
    if (!place.address.isEmpty())
        device->identity.address = place.address;
    device->identity.port = place.port;
    device->identity.keptSession = m_transport->keptSession();
    m_identity = device->identity;
    if (m_understandsCommands)
        m_control = LinkControl(*device, controlOptions(m_limits, m_transport->streamsAlways()));
    if (m_understandsCommands && device->identity.commandable)
        m_transport->writeOnCrash(encode(Command{0, StopCommand{}}));
    m_lastReport = Clock::now();
    setState(LinkState::Ready);
}

bool DeviceLink::waitUntilOpened()
{
    Lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_state != LinkState::Opening; });
    if (live())
        m_watch.begin(m_identity.sampleTime_s, m_transport->streamsAlways(),
                      m_transport->keepsComputerTime());
    return live();
}

void DeviceLink::runReader()
{
    const CrashStop::Stack ownStack;
    if (!waitUntilOpened())
        return;
    Transport::Buffer buffer{};
    for (;;) {
        waitForRoom();
        const Clock::time_point began = Clock::now();
        const Transport::ReadResult result = m_transport->read(buffer, readTimeout);
        const bool waited = Clock::now() - began > hadToWait;
        if (result.outcome == Transport::Outcome::Report)
            take(ReportView(buffer).first(std::min(result.size, buffer.size())));
        else if (result.outcome == Transport::Outcome::Timeout)
            m_watch.nothingCame(Clock::now());
        const Lock lock(m_mutex);
        if (result.outcome == Transport::Outcome::Timeout)
            m_control.heard(began + readTimeout, Clock::now());
        else if (waited)
            m_control.heard(began, Clock::now());
        if (result.outcome == Transport::Outcome::Lost)
            lose({ErrorCode::DeviceLost, {m_address, Words::tr("it was unplugged or switched off")}});
        else if (result.outcome == Transport::Outcome::Ended)
            endReplay();
        else if (result.outcome == Transport::Outcome::Timeout &&
                 silentFor(m_limits.silenceLimit, Clock::now()))
            lose({ErrorCode::DeviceLost, {m_address, Words::tr("it sent nothing for a second")}});
        if (m_state == LinkState::Closing ? mayStopReading(result.outcome) : !live())
            return;
    }
}

bool DeviceLink::mayStopReading(Transport::Outcome last) const
{
    // What a last stop brings about is still to be seen.
    const bool nothingWaits = last != Transport::Outcome::Report;
    const bool gone = last == Transport::Outcome::Lost || last == Transport::Outcome::Ended;
    return gone || (nothingWaits && m_control.mayClose(Clock::now()));
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
        const Lock lock(m_mutex);
        m_control.takeBadReport(Clock::now());
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
        return lose({ErrorCode::DeviceLost, {m_address, Words::tr("it restarted")}});
    if (!live() && m_state != LinkState::Closing)
        return;
    m_control.takeSamples(m_batch, m_samples.pushed(), now);
    if (const auto* stream = std::get_if<ReportDecoder::Stream>(&taken))
        m_control.takeState(stream->state, now);
    if (m_control.wantsToWrite(now))
        m_changed.notify_all();
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

void DeviceLink::takeAcknowledgement(const Acknowledgement& answer)
{
    const Lock lock(m_mutex);
    m_lastReport = Clock::now();
    m_unansweredSince.reset();
    m_control.takeAnswer(answer, m_lastReport);
    m_changed.notify_all();
}

void DeviceLink::runWriter()
{
    const CrashStop::Stack ownStack;
    Lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_state != LinkState::Opening; });
    while (mayWrite(Clock::now())) {
        const Clock::time_point now = Clock::now();
        const std::optional<Report> report = m_control.next(now, timePoint(m_aliveAt_ns.load()));
        if (!report) {
            m_changed.wait_until(lock, m_control.wakeAt(now));
            continue;
        }
        if (!m_unansweredSince)
            m_unansweredSince = now;
        lock.unlock();
        const bool written = m_transport->write(*report);
        lock.lock();
        // A transport that does not take it now is asked again with the command's next attempt.
        if (!written && live())
            m_changed.wait_for(lock, std::chrono::milliseconds(1));
    }
}

bool DeviceLink::mayWrite(Clock::time_point now) const
{
    return live() || (m_state == LinkState::Closing && !m_control.mayClose(now));
}

} // namespace gripscope
