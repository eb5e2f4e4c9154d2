// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/virtual_robot_transport.h"

#include "core/base/words.h"
#include "core/session/connection/device_button.h"
#include "core/signal/excitation/excitation.h"
#include "devices/virtual/virtual_button.h"
#include "devices/virtual/virtual_plug.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::uint64_t noRobotSqueeze = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t robotNoisePurpose = 2;

std::uint64_t robotSamplesIn(double seconds, double sampleTime_s)
{
    return static_cast<std::uint64_t>(std::max(1.0, std::round(seconds / sampleTime_s)));
}

} // namespace

VirtualRobot::VirtualRobot(const VirtualRobotOptions& options)
    : m_options(options),
      m_step(discretize(options.object.draw(options.seed, 0), options.sampleTime_s, options.hold)),
      m_noise(options.seed, noRobotSqueeze, robotNoisePurpose),
      m_restSamples(robotSamplesIn(rest_s, options.sampleTime_s)),
      m_squeezeSamples(robotSamplesIn(squeeze_s, options.sampleTime_s))
{
    planSqueeze(0);
}

void VirtualRobot::planSqueeze(std::uint64_t number)
{
    ExcitationOptions excitation;
    excitation.bias = bias_N;
    excitation.peak = peak_N;
    excitation.sampleTime_s = m_options.sampleTime_s;
    excitation.bit_s = std::max(excitation.bit_s, 2 * m_options.sampleTime_s);
    excitation.samples = m_squeezeSamples;
    excitation.seed = m_options.seed + number;
    // Options that make no sense would leave the fingers at rest.
    m_squeeze_N = makeExcitation(excitation).value_or(std::vector<double>(m_squeezeSamples, 0.0));
}

double VirtualRobot::plannedForce(std::uint64_t sample) const
{
    const std::uint64_t inCycle = sample % (m_restSamples + m_squeezeSamples);
    return inCycle < m_restSamples ? 0.0 : m_squeeze_N[inCycle - m_restSamples];
}

VirtualRobot::Reading VirtualRobot::next()
{
    const std::uint64_t cycle = m_restSamples + m_squeezeSamples;
    if (m_sample > 0 && m_sample % cycle == 0)
        planSqueeze(m_sample / cycle);
    const double force_N = plannedForce(m_sample);
    Reading reading;
    reading.moving = m_sample % cycle >= m_restSamples;
    reading.force_N = force_N + m_options.forceNoise_N * m_noise.normal();
    reading.position_m = contact_m + m_state[0] + m_options.positionNoise_m * m_noise.normal();
    // Every cycle begins at rest, so that the last force of one is followed by none.
    const bool last = (m_sample + 1) % cycle == 0;
    const double after_N = last ? 0.0 : plannedForce(m_sample + 1);
    m_state = (m_step.phi * m_state + m_step.gamma0 * force_N + m_step.gamma1 * after_N).eval();
    ++m_sample;
    return reading;
}

namespace {

constexpr std::uint64_t faultPurpose = 5;
/// Reports that wait for a reader; the newest are dropped behind that, as a kernel does.
constexpr std::size_t robotWireCapacity = 4096;

} // namespace

VirtualRobotTransport::VirtualRobotTransport(VirtualAddress address,
                                             std::function<Expected<GripperProfile>()> profile)
    : m_address(std::move(address)), m_findProfile(std::move(profile)),
      m_faultDice(m_address.seed, 0, faultPurpose)
{
}

Expected<void> VirtualRobotTransport::open()
{
    ASSIGN_OR_RETURN(const GripperProfile profile, m_findProfile());
    ASSIGN_OR_RETURN(const VirtualObject object, VirtualObject::fromText(m_address.object));
    ASSIGN_OR_RETURN(std::vector<FaultEvent> faults, withScript(m_address.faults, m_address.script));
    const std::optional<virtual_plug::Past> past = virtual_plug::plugIn(m_address);
    if (!past)
        return failure(
            ErrorCode::DeviceNotFound,
            {u"virtual:"_s, Words::tr("It is unplugged; its faults plug it in again by themselves.")});
    VirtualRobotOptions options;
    options.object = object;
    options.seed = m_address.seed;
    options.sampleTime_s = profile.sampleTime_s();
    options.hold = profile.hold;
    options.positionNoise_m = m_address.positionNoise_m.value_or(options.positionNoise_m);
    const std::lock_guard lock(m_mutex);
    m_device = std::make_unique<Device>(profile, options);
    m_faults = FaultTimeline(std::move(faults));
    m_faultsBefore_s = past->faults_s;
    m_start = Clock::now();
    return {};
}

Expected<protocol::Report> VirtualRobotTransport::feature(protocol::ReportId)
{
    return failure(ErrorCode::DeviceRefused,
                   {Words::tr("be asked"), Words::tr("it does not speak Gripscope's protocol")});
}

double VirtualRobotTransport::deviceTime_s() const
{
    return static_cast<double>(m_samples) * m_device->profile.sampleTime_s();
}

ProfileEncoder::Reading VirtualRobotTransport::takeSample()
{
    const FaultState& faults = m_faults.state();
    const VirtualRobot::Reading read = m_device->robot.next();
    ProfileEncoder::Reading reading{read.force_N, read.position_m, 0};
    if (read.moving)
        reading.status |= StatusMoving;
    if (faults.saturate_N && reading.force_N > *faults.saturate_N) {
        reading.force_N = *faults.saturate_N;
        reading.status |= StatusForceSaturated;
    }
    if (faults.stuck && !m_stuckAt_m)
        m_stuckAt_m = reading.position_m;
    else if (!faults.stuck)
        m_stuckAt_m.reset();
    reading.position_m = m_stuckAt_m.value_or(reading.position_m);
    if (faults.broken)
        reading.status |= StatusFault;
    if (faults.buttonDown || virtual_button::down())
        reading.status |= statusButton;
    ++m_samples;
    return reading;
}

void VirtualRobotTransport::unplug()
{
    m_unplugged = true;
    const std::optional<double> replug_s = m_faults.nextReplug_s();
    if (!replug_s)
        return;
    const double ahead_s = *replug_s - m_faultsBefore_s - deviceTime_s();
    const std::chrono::duration<double> wait(realTime() ? ahead_s / m_address.speed : 0);
    virtual_plug::unplug(m_address, Clock::now() + std::chrono::duration_cast<Clock::duration>(wait),
                         {*replug_s, 0});
}

void VirtualRobotTransport::sendReport()
{
    m_faults.advanceTo(m_faultsBefore_s + deviceTime_s());
    const FaultState& faults = m_faults.state();
    if (faults.unplugged)
        return unplug();
    const double time_s = deviceTime_s() + faults.clock_s;
    std::vector<ProfileEncoder::Reading> readings;
    readings.reserve(m_device->profile.samples);
    for (std::size_t i = 0; i < m_device->profile.samples; ++i)
        readings.push_back(takeSample());
    pass(m_device->encoder.encode(readings, std::max(0.0, time_s)));
}

void VirtualRobotTransport::pass(std::vector<std::uint8_t> report)
{
    const FaultState& faults = m_faults.state();
    // All drawn every time, so that one fault does not move the others.
    const bool lost = m_faultDice.uniform() < faults.loss;
    const bool doubled = m_faultDice.uniform() < faults.duplicate;
    const bool damaged = m_faultDice.uniform() < faults.badCrc;
    const std::uint64_t bit = m_faultDice.bits() % (8 * report.size());
    if (lost || faults.stalled || m_wire.size() >= robotWireCapacity)
        return;
    if (damaged)
        report[bit / 8] = static_cast<std::uint8_t>(report[bit / 8] ^ (1U << bit % 8));
    if (doubled)
        m_wire.push_back(report);
    m_wire.push_back(std::move(report));
}

void VirtualRobotTransport::advance()
{
    if (!realTime()) {
        while (m_wire.empty() && !m_unplugged && m_samples < samplesAtSpeedZero)
            sendReport();
        return;
    }
    const double now_s = std::chrono::duration<double>(Clock::now() - m_start).count() * m_address.speed;
    while (!m_unplugged && deviceTime_s() + m_device->profile.reportTime_s() <= now_s)
        sendReport();
}

Transport::ReadResult VirtualRobotTransport::read(Buffer& buffer, std::chrono::milliseconds timeout)
{
    std::unique_lock lock(m_mutex);
    const Clock::time_point deadline = Clock::now() + timeout;
    for (;;) {
        if (m_closed || !m_device)
            return {Outcome::Lost};
        advance();
        if (!m_wire.empty()) {
            const std::vector<std::uint8_t>& report = m_wire.front();
            const std::size_t size = report.size();
            std::copy(report.begin(), report.end(), buffer.begin());
            m_wire.pop_front();
            return {Outcome::Report, size};
        }
        if (m_unplugged)
            return {Outcome::Lost};
        if (!realTime())
            return {Outcome::Ended};
        if (Clock::now() >= deadline)
            return {Outcome::Timeout};
        m_wake.wait_until(lock, std::min(deadline, Clock::now() + std::chrono::milliseconds(1)));
    }
}

void VirtualRobotTransport::close() noexcept
{
    {
        const std::lock_guard lock(m_mutex);
        m_closed = true;
    }
    m_wake.notify_all();
}

} // namespace gripscope
