// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/device_link.h"

#include "core/base/words.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

void RateMeter::take(TimePoint now, std::uint64_t reports, std::uint64_t samples)
{
    if (m_count > 0 && now - m_marks[(m_count - 1) % marks].time < spacing)
        return;
    m_marks[m_count++ % marks] = {now, reports, samples};
    const Mark& oldest = m_marks[m_count < marks ? 0 : m_count % marks];
    const double seconds = std::chrono::duration<double>(now - oldest.time).count();
    if (!(seconds > 0))
        return;
    m_reportRate_Hz = static_cast<double>(reports - oldest.reports) / seconds;
    m_sampleRate_Hz = static_cast<double>(samples - oldest.samples) / seconds;
}

DeviceLink::DeviceLink(std::shared_ptr<Transport> transport, std::unique_ptr<ReportDecoder> decoder,
                       QString address, std::size_t queueCapacity, const LinkLimits& limits)
    : m_transport(std::move(transport)), m_decoder(std::move(decoder)),
      m_understandsCommands(m_decoder->understandsCommands()), m_address(std::move(address)),
      m_limits(limits), m_samples(queueCapacity)
{
}

LinkState DeviceLink::state() const
{
    const Lock lock(m_mutex);
    return live() && m_control.armed() ? LinkState::Armed : m_state;
}

std::optional<Error> DeviceLink::lastError() const
{
    const Lock lock(m_mutex);
    return m_error ? m_error : m_control.error();
}

GripperIdentity DeviceLink::identity() const
{
    const Lock lock(m_mutex);
    return m_identity;
}

SqueezeState DeviceLink::squeezeState() const
{
    const Lock lock(m_mutex);
    const LinkControl::Squeeze& squeeze = m_control.squeeze();
    const bool ended = squeeze.state == SqueezeState::Finished || squeeze.state == SqueezeState::Stopped;
    return ended && m_samples.popped() < squeeze.samplesBefore ? SqueezeState::Running : squeeze.state;
}

StopState DeviceLink::stopState() const
{
    const Lock lock(m_mutex);
    const StopState state = m_control.stopState(Clock::now());
    // What was not confirmed before the connection ended never will be.
    return state == StopState::Waiting && m_state == LinkState::Closed ? StopState::NotObeyed : state;
}

std::optional<Error> DeviceLink::disarmReason() const
{
    const Lock lock(m_mutex);
    return m_control.disarmReason();
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
    m_control.fill(counters);
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
    want([](LinkControl& control, Clock::time_point now) { control.arm(now); });
}

void DeviceLink::disarm()
{
    want([](LinkControl& control, Clock::time_point now) { control.disarm(now); });
}

void DeviceLink::startExcitation(const AdmittedExcitation& excitation)
{
    {
        const Lock lock(m_mutex);
        if (takesCommands())
            m_control.start(excitation, Clock::now());
        else
            m_control.refuseSqueeze();
    }
    m_changed.notify_all();
}

void DeviceLink::finishExcitation()
{
    want([](LinkControl& control, Clock::time_point) { control.finish(); });
}

void DeviceLink::stop() noexcept
{
    want([](LinkControl& control, Clock::time_point now) { control.stop(now); });
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
    m_control.lose();
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

void DeviceLink::beginClosing()
{
    {
        const Lock lock(m_mutex);
        if (takesCommands())
            m_control.close(Clock::now());
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
