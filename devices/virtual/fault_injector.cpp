// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/fault_injector.h"

namespace gripscope {

namespace {
constexpr std::uint64_t streamPurpose = 3;
constexpr std::uint64_t acknowledgementPurpose = 4;
constexpr std::uint64_t noSqueeze = ~std::uint64_t(0);
} // namespace

FaultInjector::FaultInjector(const VirtualFaults& faults, std::uint64_t seed)
    : m_faults(faults), m_seed(seed), m_stream(seed, noSqueeze, streamPurpose),
      m_acknowledgements(seed, noSqueeze, acknowledgementPurpose)
{
}

void FaultInjector::beginSqueeze(std::uint64_t number)
{
    m_stream = RandomStream(m_seed, number, streamPurpose);
}

void FaultInjector::pass(const protocol::Report& report, std::deque<protocol::Report>& wire)
{
    const bool isStream = report[0] == static_cast<std::uint8_t>(protocol::ReportId::Stream);
    RandomStream& random = isStream ? m_stream : m_acknowledgements;
    // All drawn every time, so that one fault does not move the others.
    const bool lost = random.uniform() < m_faults.lossProbability;
    const bool doubled = random.uniform() < m_faults.duplicateProbability;
    const bool damaged = random.uniform() < m_faults.badCrcProbability;
    const std::uint64_t bit = random.bits() % (8 * protocol::reportSize);
    if (lost)
        return;
    protocol::Report arriving = report;
    if (damaged)
        arriving[bit / 8] = static_cast<std::uint8_t>(arriving[bit / 8] ^ (1U << bit % 8));
    wire.push_back(arriving);
    if (doubled)
        wire.push_back(arriving);
}

} // namespace gripscope
