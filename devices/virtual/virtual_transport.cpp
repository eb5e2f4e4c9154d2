// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_transport.h"

#include <algorithm>

namespace gripscope {

namespace {
/// Reports that wait for a reader, about 4 s; the newest are dropped behind that, as a kernel does.
constexpr std::size_t wireCapacity = 4096;
} // namespace

Expected<std::shared_ptr<VirtualTransport>> VirtualTransport::make(const VirtualAddress& address)
{
    Expected<VirtualObject> object = VirtualObject::fromText(address.object);
    if (!object)
        return tl::unexpected(object.error());
    VirtualFirmwareOptions options;
    options.object = *object;
    options.objectName = address.object;
    options.seed = address.seed;
    if (address.positionNoise_m)
        options.positionNoise_m = *address.positionNoise_m;
    options.saturateForce_N = address.faults.saturateForce_N;
    options.sensorStuck = address.faults.sensorStuck;
    options.millimetres = address.faults.millimetres;
    options.hasWatchdog = address.speed > 0;
    return std::make_shared<VirtualTransport>(address, std::move(options));
}

VirtualTransport::VirtualTransport(const VirtualAddress& address, VirtualFirmwareOptions options)
    : m_address(address), m_firmware(std::move(options)), m_faults(address.faults, address.seed)
{
}

Expected<void> VirtualTransport::open()
{
    const std::lock_guard lock(m_mutex);
    m_start = Clock::now();
    m_open = true;
    return {};
}

std::uint64_t VirtualTransport::hostTime_us() const
{
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - m_start).count());
}

bool VirtualTransport::past(const std::optional<double>& device_s) const
{
    return device_s &&
           static_cast<double>(m_firmware.samplesTaken()) * VirtualFirmware::sampleTime_s >= *device_s;
}

Expected<protocol::Report> VirtualTransport::feature(protocol::ReportId id)
{
    const std::lock_guard lock(m_mutex);
    const std::optional<protocol::Report> report = m_firmware.feature(static_cast<std::uint8_t>(id));
    if (!m_open || m_closed || !report)
        return failure(ErrorCode::DeviceLost, {QStringLiteral("virtual:"), QStringLiteral("it is not open")});
    return *report;
}

void VirtualTransport::deliver()
{
    std::deque<protocol::Report>& outbox = m_firmware.outbox();
    for (; !outbox.empty(); outbox.pop_front()) {
        const bool silent = past(m_address.faults.stallAfter_s) || unplugged();
        if (!silent && m_wire.size() < wireCapacity)
            m_faults.pass(outbox.front(), m_wire);
    }
    if (m_firmware.squeezesStarted() != m_squeezesSeen) {
        m_squeezesSeen = m_firmware.squeezesStarted();
        m_faults.beginSqueeze(m_squeezesSeen);
    }
}

void VirtualTransport::takeSample(std::uint64_t now_us)
{
    m_firmware.sample(now_us);
    deliver();
}

void VirtualTransport::advance()
{
    if (!realTime()) {
        while (m_wire.empty() && m_firmware.busy())
            takeSample(0);
        return;
    }
    const double rate = m_address.speed / VirtualFirmware::sampleTime_s * 1e-6; // samples in a microsecond
    const std::uint64_t now_us = hostTime_us();
    const auto due = static_cast<std::uint64_t>(static_cast<double>(now_us) * rate);
    while (m_firmware.samplesTaken() < due && !unplugged()) {
        const auto at_us = static_cast<std::uint64_t>(static_cast<double>(m_firmware.samplesTaken()) / rate);
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
        if (unplugged())
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
        const std::lock_guard lock(m_mutex);
        if (!m_open || m_closed)
            return false;
        if (realTime())
            advance();
        // A squeeze that is being followed by rest is shown to its end, whenever the next command comes.
        while (!realTime() && m_firmware.settling())
            takeSample(0);
        if (unplugged())
            return false;
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
