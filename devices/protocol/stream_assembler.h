// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_port.h"
#include "devices/protocol/codec.h"

#include <vector>

namespace gripscope::protocol {

/// Turns stream reports into samples on a clock and a count that never wrap, and counts what went missing.
///
/// The 32-bit counters of the wire are continued to 64 bits from one report to the next: a step of less than
/// 2^31 is forward. The first report sets the zero of neither: sequence and time start at what the device
/// sends. Reports come in order or twice, never swapped (USB keeps the order), so a report number up to 64
/// behind is a duplicate and one further behind means that the device began anew.
class StreamAssembler {
public:
    enum class Outcome { Accepted, Duplicate, Restarted };

    StreamAssembler(double forcePerCount, double positionPerCount, double sampleTime_s)
        : m_forcePerCount(forcePerCount), m_positionPerCount(positionPerCount), m_sampleTime_s(sampleTime_s)
    {
    }

    /// Appends the report's samples to `samples`; nothing unless Accepted.
    Outcome take(const StreamReport& report, std::vector<Sample>& samples);

    [[nodiscard]] std::uint64_t lostSamples() const { return m_lostSamples; }
    [[nodiscard]] std::uint64_t duplicateReports() const { return m_duplicateReports; }

private:
    double m_forcePerCount, m_positionPerCount, m_sampleTime_s;
    bool m_started = false;
    std::uint32_t m_lastReport = 0;
    std::uint64_t m_nextSample = 0;   ///< the sequence number that should come next
    std::uint64_t m_timestamp_us = 0; ///< of the last report, without wraps
    std::uint64_t m_lostSamples = 0;
    std::uint64_t m_duplicateReports = 0;
};

} // namespace gripscope::protocol
