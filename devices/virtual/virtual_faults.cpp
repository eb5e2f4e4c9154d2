// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_faults.h"

#include "devices/protocol/codec.h"

namespace gripscope {

namespace {

constexpr std::uint64_t streamPurpose = 3;
constexpr std::uint64_t acknowledgementPurpose = 4;
constexpr std::uint64_t noInjectedSqueeze = ~std::uint64_t(0);

bool isStream(const protocol::Report& report)
{
    return report[0] == static_cast<std::uint8_t>(protocol::ReportId::Stream);
}

} // namespace

FaultInjector::FaultInjector(std::uint64_t seed)
    : m_seed(seed), m_stream(seed, noInjectedSqueeze, streamPurpose),
      m_acknowledgements(seed, noInjectedSqueeze, acknowledgementPurpose)
{
}

void FaultInjector::beginSqueeze(std::uint64_t number)
{
    m_stream = RandomStream(m_seed, number, streamPurpose);
}

std::uint64_t FaultInjector::countSent(const protocol::Report& report)
{
    const protocol::Decoded<protocol::InputMessage> message = protocol::decodeInput(report);
    const auto* stream = message ? std::get_if<protocol::StreamReport>(&*message) : nullptr;
    if (!stream || stream->count == 0)
        return 0;
    m_counts.samples += stream->count;
    m_counts.first = m_counts.first.value_or(stream->firstSample);
    m_counts.last = std::uint64_t(stream->firstSample) + stream->count - 1;
    return stream->count;
}

void FaultInjector::lose(const protocol::Report& report)
{
    m_counts.lostSamples += countSent(report);
}

void FaultInjector::pass(const protocol::Report& report, const FaultState& faults,
                         std::deque<protocol::Report>& wire)
{
    RandomStream& random = isStream(report) ? m_stream : m_acknowledgements;
    // All drawn every time, so that one fault does not move the others.
    const bool lost = random.uniform() < faults.loss;
    const bool doubled = random.uniform() < faults.duplicate;
    const bool damaged = random.uniform() < faults.badCrc;
    const std::uint64_t bit = random.bits() % (8 * protocol::reportSize);
    if (lost)
        return lose(report);
    const std::uint64_t samples = countSent(report);
    protocol::Report arriving = report;
    if (damaged) {
        arriving[bit / 8] = static_cast<std::uint8_t>(arriving[bit / 8] ^ (1U << bit % 8));
        m_counts.lostSamples += samples;
        m_counts.damagedReports += doubled ? 2 : 1;
    }
    wire.push_back(arriving);
    if (!doubled)
        return;
    wire.push_back(arriving);
    if (!damaged && isStream(report))
        ++m_counts.duplicateReports;
}

} // namespace gripscope
