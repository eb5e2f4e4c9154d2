// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/device_link.h"

#include "core/words.h"

#include <algorithm>

namespace gripscope {

using namespace protocol;
using namespace Qt::StringLiterals;

namespace {

std::int64_t nanoseconds(DeviceLink::Clock::time_point t)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(t.time_since_epoch()).count();
}

DeviceLink::Clock::time_point timePoint(std::int64_t since_ns)
{
    return DeviceLink::Clock::time_point(
        std::chrono::duration_cast<DeviceLink::Clock::duration>(std::chrono::nanoseconds(since_ns)));
}

/// What was asked, to follow "the gripper refused to" or "the gripper did not".
QString inWords(const CommandBody& body)
{
    switch (reportId(body)) {
    case ReportId::Arm:
        return Words::tr("arm");
    case ReportId::Disarm:
        return Words::tr("disarm");
    case ReportId::Stop:
        return Words::tr("confirm the stop");
    case ReportId::SetLimits:
        return Words::tr("take the limits of the squeeze");
    case ReportId::Upload:
        return Words::tr("take the force signal");
    case ReportId::Start:
        return Words::tr("start the squeeze");
    case ReportId::Finish:
        return Words::tr("end the squeeze early");
    default:
        return u"answer"_qs;
    }
}

} // namespace

DeviceLink::DeviceLink(std::shared_ptr<Transport> transport, std::unique_ptr<ReportDecoder> decoder,
                       QString address, std::size_t queueCapacity)
    : m_transport(std::move(transport)), m_decoder(std::move(decoder)),
      m_understandsCommands(m_decoder->understandsCommands()), m_address(std::move(address)),
      m_samples(queueCapacity)
{
}

LinkState DeviceLink::state() const
{
    const Lock lock(m_mutex);
    return m_state;
}

std::optional<Error> DeviceLink::lastError() const
{
    const Lock lock(m_mutex);
    return m_error;
}

GripperIdentity DeviceLink::identity() const
{
    const Lock lock(m_mutex);
    return m_device.identity;
}

SqueezeState DeviceLink::squeezeState() const
{
    const Lock lock(m_mutex);
    const bool ended = m_squeeze.state == SqueezeState::Finished || m_squeeze.state == SqueezeState::Stopped;
    return ended && m_samples.popped() < m_squeeze.samplesBefore ? SqueezeState::Running : m_squeeze.state;
}

LinkCounters DeviceLink::counters() const
{
    LinkCounters counters;
    m_watch.fill(counters);
    counters.samples = m_samples.pushed();
    counters.droppedSamples = m_droppedSamples.load();
    counters.reportRate_Hz = m_rates.reportRate_Hz();
    counters.sampleRate_Hz = m_rates.sampleRate_Hz();
    counters.newestArrival = m_takenArrival;
    counters.latency_ms = m_latency_ms;
    counters.latency50_ms = m_latencies.quantile_ms(0.50, Clock::now());
    counters.latency99_ms = m_latencies.quantile_ms(0.99, Clock::now());
    const Lock lock(m_mutex);
    m_commands.fill(counters);
    return counters;
}

std::size_t DeviceLink::drain(std::vector<Sample>& samples, std::size_t most)
{
    const Clock::time_point arrived = timePoint(m_newestArrival_ns.load());
    const std::size_t count = m_samples.pop(samples, most);
    const Clock::time_point now = Clock::now();
    LinkCounters counters;
    m_watch.fill(counters);
    m_rates.take(now, counters.reports, m_samples.pushed());
    if (count == 0)
        return 0;
    m_lastDrained = samples.back().sequence;
    m_takenArrival = arrived;
    timeTakingOver(std::span(samples).last(count), now);
    return count;
}

void DeviceLink::note(const QString& text)
{
    // The reader may be ahead of the owner by what is in the queue: this says where the owner was.
    m_transport->note(m_lastDrained ? text + u"after: %1\n"_qs.arg(*m_lastDrained) : text);
}

void DeviceLink::timeTakingOver(std::span<const Sample> taken, Clock::time_point now)
{
    const double age_ms = std::chrono::duration<double, std::milli>(now - *m_takenArrival).count();
    constexpr double weight = 0.1; // smooths over some ten calls
    m_latency_ms += weight * (std::max(0.0, age_ms) - m_latency_ms);
    // Those before the newest came as much earlier as the device took them earlier.
    for (const Sample& sample : taken)
        m_latencies.add(age_ms + 1000 * (taken.back().time_s - sample.time_s), now);
}

void DeviceLink::confirmAlive() noexcept
{
    m_aliveAt_ns.store(nanoseconds(Clock::now()));
}

void DeviceLink::arm()
{
    confirmAlive(); // whoever arms is there
    {
        const Lock lock(m_mutex);
        if (!takesCommands())
            return;
        m_error.reset();
        m_commands.push(ArmCommand{});
    }
    m_changed.notify_all();
}

void DeviceLink::disarm()
{
    {
        const Lock lock(m_mutex);
        if (!takesCommands())
            return;
        if (m_squeeze.state == SqueezeState::Uploading) { // it would be started, only to be ended
            m_commands.clear();
            endSqueeze(SqueezeState::Stopped);
        }
        m_commands.push(DisarmCommand{});
    }
    m_changed.notify_all();
}

void DeviceLink::startExcitation(const AdmittedExcitation& excitation)
{
    {
        const Lock lock(m_mutex);
        if (!takesCommands()) {
            m_squeeze.state = SqueezeState::Refused;
            return;
        }
        m_error.reset();
        const std::uint16_t number = m_nextExcitation++;
        m_squeeze = {SqueezeState::Uploading, number, 0};
        const SetLimitsCommand limits =
            m_device.limitCounts(excitation.maxForce_N(), excitation.maxTravel_m());
        m_commands.push(limits);
        std::vector<std::int32_t> forces;
        forces.reserve(excitation.force_N().size());
        // A force at the limit may be rounded up, the limit never is.
        for (const double force_N : excitation.force_N())
            forces.push_back(std::min(m_device.forceCounts(force_N), limits.maxForce));
        for (std::size_t first = 0; first < forces.size(); first += maxForcesPerUpload) {
            UploadCommand chunk{number, static_cast<std::uint32_t>(first), 0, {}};
            const std::size_t count = std::min(maxForcesPerUpload, forces.size() - first);
            chunk.count = static_cast<std::uint8_t>(count);
            std::copy_n(forces.begin() + static_cast<std::ptrdiff_t>(first), count, chunk.forces.begin());
            m_commands.push(chunk);
        }
        m_commands.push(StartCommand{number, static_cast<std::uint32_t>(forces.size()), forcesCrc(forces)});
    }
    m_changed.notify_all();
}

void DeviceLink::finishExcitation()
{
    {
        const Lock lock(m_mutex);
        if (!takesCommands() || m_squeeze.state != SqueezeState::Running)
            return;
        m_commands.push(FinishCommand{m_squeeze.number});
    }
    m_changed.notify_all();
}

void DeviceLink::stop() noexcept
{
    {
        const Lock lock(m_mutex);
        if (!takesCommands())
            return;
        m_commands.stop();
        if (m_squeeze.state == SqueezeState::Uploading)
            endSqueeze(SqueezeState::Stopped);
    }
    m_changed.notify_all();
}

void DeviceLink::setState(LinkState state)
{
    if (m_state == state || m_state == LinkState::Closed || m_state == LinkState::Closing)
        return;
    m_state = state;
    m_changed.notify_all();
}

void DeviceLink::lose(Error error)
{
    if (m_state == LinkState::Closed || m_state == LinkState::Closing || m_state == LinkState::Lost)
        return;
    m_error = std::move(error);
    m_commands.clear();
    if (m_squeeze.state == SqueezeState::Uploading || m_squeeze.state == SqueezeState::Running)
        endSqueeze(SqueezeState::Stopped);
    setState(LinkState::Lost);
}

void DeviceLink::endReplay()
{
    if (!live())
        return;
    m_error = Error{ErrorCode::NotFound,
                    {Words::tr("further sample at %1: it was replayed to its end").arg(m_address)}};
    setState(LinkState::Closed);
}

void DeviceLink::endSqueeze(SqueezeState state)
{
    m_squeeze.state = state;
    m_squeeze.samplesBefore = m_samples.pushed();
}

void DeviceLink::follow(std::uint16_t status, ExcitationState excitation, std::uint16_t number)
{
    if (!live())
        return;
    const bool armed = status & StatusArmed;
    if (!armed)
        m_armAnswered = false;
    setState(armed && m_armAnswered ? LinkState::Armed : LinkState::Ready);
    const bool open = m_squeeze.state == SqueezeState::Uploading || m_squeeze.state == SqueezeState::Running;
    if (!open || number != m_squeeze.number)
        return;
    if (excitation == ExcitationState::Running)
        m_squeeze.state = SqueezeState::Running;
    else if (excitation == ExcitationState::Finished)
        endSqueeze(SqueezeState::Finished);
    else if (excitation == ExcitationState::Stopped)
        endSqueeze(SqueezeState::Stopped);
}

void DeviceLink::settle(const CommandQueue::Outcome& outcome)
{
    const bool fine = outcome.result == CommandResult::Done || outcome.result == CommandResult::Repeated;
    // A device that does not end a squeeze early ends it later by itself.
    if (!fine && !std::holds_alternative<FinishCommand>(outcome.body))
        return refuse(outcome);
    if (std::holds_alternative<ArmCommand>(outcome.body)) {
        m_armAnswered = true;
        m_nextExcitation = static_cast<std::uint16_t>(outcome.detail + 1);
    }
}

void DeviceLink::refuse(const CommandQueue::Outcome& outcome)
{
    const QString asked = inWords(outcome.body);
    if (outcome.result)
        m_error = Error{ErrorCode::DeviceRefused, {asked, Words::tr(describe(*outcome.result))}};
    else
        m_error = Error{ErrorCode::DeviceTimeout, {asked, u"1"_qs}};
    // What was to follow makes no sense any more.
    if (!m_commands.stopping())
        m_commands.clear();
    if (m_squeeze.state == SqueezeState::Uploading)
        endSqueeze(SqueezeState::Refused);
}

void DeviceLink::beginClosing()
{
    {
        const Lock lock(m_mutex);
        const bool stopIsDue = m_state == LinkState::Armed || !m_commands.empty();
        m_commands.clear();
        if (live() && stopIsDue)
            m_commands.stop();
        setState(LinkState::Closing);
    }
    m_changed.notify_all();
}

void DeviceLink::closeTransport()
{
    m_transport->close();
}

void DeviceLink::finishClosing()
{
    const Lock lock(m_mutex);
    m_state = LinkState::Closed;
}

} // namespace gripscope
