// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commanded_force.h"

namespace gripscope {

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
