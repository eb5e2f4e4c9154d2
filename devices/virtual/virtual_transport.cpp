// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_transport.h"

#include "core/base/words.h"
#include "devices/virtual/virtual_button.h"
#include "devices/virtual/virtual_load.h"
#include "devices/virtual/virtual_plug.h"

#include <algorithm>
#include <thread>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
/// Reports that wait for a reader, about 4 s; the newest are dropped behind that, as a kernel does.
constexpr std::size_t wireCapacity = 4096;
} // namespace

Expected<std::shared_ptr<VirtualTransport>> VirtualTransport::make(const VirtualAddress& address,
                                                                   std::chrono::milliseconds patience)
{
    ASSIGN_OR_RETURN(VirtualObject object, VirtualObject::fromText(address.object));
    if (address.study)
        object.takePartOf(*address.study);
    VirtualFirmwareOptions options;
    options.object = object;
    options.objectName = address.object;
    options.terms = address.terms;
    options.sampleTime_s = 1 / address.samplesPerSecond;
    options.jitter_s = address.jitter_s;
    options.seed = address.seed;
    if (address.study)
        options.noiseSeed = address.study->noiseSeed();
    if (address.positionNoise_m)
        options.positionNoise_m = *address.positionNoise_m;
    options.millimetres = address.millimetres;
    options.hasWatchdog = address.speed > 0;
    options.patience_ms = static_cast<std::uint32_t>(std::max<std::int64_t>(0, patience.count()));
    return std::make_shared<VirtualTransport>(address, std::move(options));
}

VirtualTransport::VirtualTransport(const VirtualAddress& address, VirtualFirmwareOptions options)
    : m_address(address), m_firmware(std::move(options)), m_injector(address.seed)
{
}

Expected<void> VirtualTransport::open()
{
    ASSIGN_OR_RETURN(std::vector<FaultEvent> faults, withScript(m_address.faults, m_address.script));
    const std::optional<virtual_plug::Past> past = virtual_plug::plugIn(m_address);
    if (!past)
        return failure(
            ErrorCode::DeviceNotFound,
            {u"virtual:"_qs, Words::tr("It is unplugged; its faults plug it in again by themselves.")});
    const std::lock_guard lock(m_mutex);
    m_timeline = FaultTimeline(std::move(faults));
    m_faultsBefore_s = past->faults_s;
    m_firmware.goOnAfter(past->squeezes);
    m_squeezesSeen = past->squeezes;
    m_start = Clock::now();
    m_open = true;
    followFaults();
    return {};
}

std::uint64_t VirtualTransport::hostTime_us() const
{
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - m_start).count());
}

double VirtualTransport::faults_s() const
{
    return m_faultsBefore_s + static_cast<double>(m_firmware.samplesTaken()) * m_firmware.sampleTime_s();
}

void VirtualTransport::followFaults()
{
    m_timeline.advanceTo(faults_s());
    const FaultState& now = m_timeline.state();
    m_firmware.setFaults({now.saturate_N, now.stuck, now.broken, now.clock_s,
                          now.load_N + virtual_load::load_N(), now.buttonDown || virtual_button::down(),
                          now.noWatchdog, now.clockRate});
    if (const double rate = m_address.speed * (1 + now.clockRate) / (1e6 * m_firmware.sampleTime_s());
        rate != m_pace.rate)
        m_pace = {m_pace.at_us(m_firmware.samplesTaken()), m_firmware.samplesTaken(), rate};
    if (now.unplugged && !m_unplugged) {
        m_unplugged = true;
        rememberUnplug();
    }
}

void VirtualTransport::rememberUnplug() const
{
    const std::optional<double> replug_s = m_timeline.nextReplug_s();
    if (!replug_s)
        return;
    const double wait_s = realTime() ? (*replug_s - faults_s()) / m_address.speed : 0;
    const auto wait = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait_s));
    virtual_plug::unplug(m_address, Clock::now() + wait, {*replug_s, m_firmware.squeezesStarted()});
}

bool VirtualTransport::hang(Lock& lock, double seconds)
{
    if (seconds <= 0)
        return false;
    lock.unlock();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    lock.lock();
    return true;
}

FaultCounts VirtualTransport::faultCounts()
{
    const std::lock_guard lock(m_mutex);
    return m_injector.counts();
}

Expected<protocol::Report> VirtualTransport::feature(protocol::ReportId id)
{
    Lock lock(m_mutex);
    if (usable() && realTime())
        advance();
    if (const double hangs_s = m_timeline.state().featureHangs_s; hang(lock, hangs_s))
        return failure(ErrorCode::DeviceTimeout, {Words::tr("say what it is"), QString::number(hangs_s)});
    const std::optional<protocol::Report> report = m_firmware.feature(static_cast<std::uint8_t>(id));
    if (!usable() || !report)
        return failure(ErrorCode::DeviceLost, {u"virtual:"_qs, Words::tr("it is not open")});
    return *report;
}

void VirtualTransport::deliver()
{
    std::deque<protocol::Report>& outbox = m_firmware.outbox();
    for (; !outbox.empty(); outbox.pop_front()) {
        const bool silent = m_timeline.state().stalled || m_unplugged;
        if (!silent && m_wire.size() < wireCapacity)
            m_injector.pass(outbox.front(), m_timeline.state(), m_wire);
        else
            m_injector.lose(outbox.front());
    }
    if (m_firmware.squeezesStarted() != m_squeezesSeen) {
        m_squeezesSeen = m_firmware.squeezesStarted();
        m_injector.beginSqueeze(m_squeezesSeen);
    }
}

void VirtualTransport::takeSample(std::uint64_t now_us)
{
    m_firmware.sample(now_us);
    followFaults();
    deliver();
}

void VirtualTransport::advance()
{
    if (!realTime()) {
        while (m_wire.empty() && m_firmware.busy() && !m_unplugged)
            takeSample(0);
        return;
    }
    const std::uint64_t now_us = hostTime_us();
    for (;;) {
        const auto at_us = static_cast<std::uint64_t>(m_pace.at_us(m_firmware.samplesTaken()));
        const auto next_us = static_cast<std::uint64_t>(m_pace.at_us(m_firmware.samplesTaken() + 1));
        if (next_us > now_us || m_unplugged)
            return;
        takeSample(std::min(at_us, now_us));
    }
}

Transport::ReadResult VirtualTransport::read(Buffer& buffer, std::chrono::milliseconds timeout)
{
    std::unique_lock lock(m_mutex);
    const Clock::time_point deadline = Clock::now() + timeout;
    for (;;) {
        if (m_closed || !m_open)
            return {Outcome::Lost};
        advance();
        if (m_unplugged)
            return {Outcome::Lost};
        if (!m_wire.empty()) {
            std::copy(m_wire.front().begin(), m_wire.front().end(), buffer.begin());
            m_wire.pop_front();
            return {Outcome::Report, protocol::reportSize};
        }
        if (Clock::now() >= deadline)
            return {Outcome::Timeout};
        const Clock::time_point next = Clock::now() + std::chrono::milliseconds(1);
        m_wake.wait_until(lock, realTime() ? std::min(deadline, next) : deadline);
    }
}

bool VirtualTransport::write(const protocol::Report& report)
{
    {
        Lock lock(m_mutex);
        if (!usable())
            return false;
        if (realTime())
            advance();
        if (hang(lock, m_timeline.state().writeHangs_s))
            return false;
        // A squeeze that is being followed by rest is shown to its end, whenever the next command comes.
        while (!realTime() && m_firmware.settling() && !m_unplugged)
            takeSample(0);
        if (!usable())
            return false;
        if (m_timeline.state().deaf(report[0]))
            return true;
        m_firmware.receive(report, realTime() ? hostTime_us() : 0);
        deliver();
    }
    m_wake.notify_all();
    return true;
}

void VirtualTransport::close() noexcept
{
    {
        const std::lock_guard lock(m_mutex);
        m_closed = true;
    }
    m_wake.notify_all();
}

} // namespace gripscope
