// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/virtual_robot.h"

#include "core/signal/excitation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

constexpr std::uint64_t noSqueeze = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t noisePurpose = 2;

std::uint64_t samplesIn(double seconds, double sampleTime_s)
{
    return static_cast<std::uint64_t>(std::max(1.0, std::round(seconds / sampleTime_s)));
}

} // namespace

VirtualRobot::VirtualRobot(const VirtualRobotOptions& options)
    : m_options(options),
      m_step(discretize(options.object.draw(options.seed, 0), options.sampleTime_s, options.hold)),
      m_noise(options.seed, noSqueeze, noisePurpose), m_restSamples(samplesIn(rest_s, options.sampleTime_s)),
      m_squeezeSamples(samplesIn(squeeze_s, options.sampleTime_s))
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

} // namespace gripscope
