// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/feed/live_feed.h"

#include <limits>

namespace gripscope {

namespace {
/// A longer loss is a new squeeze for all that can be told on line.
constexpr std::uint64_t longestLoss = 100;
} // namespace

void LiveEstimate::reset(double sampleTime_s, ForceHold hold, double forceLag_s)
{
    *this = {};
    m_options.sampleTime_s = sampleTime_s;
    m_options.hold = hold;
    m_options.lag_s = forceLag_s;
}

void LiveEstimate::append(const std::vector<Sample>& samples)
{
    for (const Sample& sample : samples)
        take(sample);
}

void LiveEstimate::take(const Sample& sample)
{
    const bool moving = (sample.status & StatusMoving) != 0;
    const std::uint64_t lost = sample.sequence > m_lastSequence ? sample.sequence - m_lastSequence - 1 : 0;
    if (moving && (!m_moving || lost > longestLoss))
        m_estimator.emplace(m_options);
    else if (moving)
        for (std::uint64_t i = 0; i < lost; ++i)
            m_estimator->update(std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN());
    if (moving)
        m_estimator->update(sample.force, sample.position);
    m_moving = moving;
    m_lastSequence = sample.sequence;
}

std::optional<RecursiveState> LiveEstimate::state() const
{
    return m_estimator ? std::optional(m_estimator->state()) : std::nullopt;
}

void CommandedForce::begin(const Sample& first, const SafetyGate::Started& started)
{
    const bool ours = started.number != m_taken;
    const bool seen = m_newest && first.sequence == m_newest->sequence + 1;
    m_taken = started.number;
    m_firstSequence = first.sequence;
    m_force_N = ours && seen ? started.force_N : std::vector<double>();
}

std::vector<std::optional<double>> CommandedForce::follow(const std::vector<Sample>& samples,
                                                          const SafetyGate::Started& started)
{
    std::vector<std::optional<double>> forces_N;
    forces_N.reserve(samples.size());
    for (const Sample& sample : samples) {
        const bool moving = sample.status & StatusMoving;
        if (moving && !(m_newest && m_newest->status & StatusMoving))
            begin(sample, started);
        const std::uint64_t index = sample.sequence - m_firstSequence;
        forces_N.push_back(moving && index < m_force_N.size() ? std::optional(m_force_N[index])
                                                              : std::nullopt);
        m_newest = sample;
    }
    return forces_N;
}

} // namespace gripscope
