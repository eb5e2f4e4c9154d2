// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/protocol/codec.h"

#include <optional>
#include <vector>

namespace gripscope::protocol {

/// Turns stream reports into samples on a clock and a count that never wrap, and counts what went missing.
///
/// The 32-bit counters of the wire are continued to 64 bits from one report to the next: a step of less than
/// 2^31 is forward. The first report sets the zero of neither: sequence and time start at what the device
/// sends. Reports come in order or twice, never swapped (USB keeps the order), so a report number up to 64
/// behind is a duplicate and one further behind means that the device began anew, as does a sample number
/// behind.
///
/// Time and sample count must agree (stepsContradict()); where they do not, the device's clock was set. A
/// step forward stays in the samples' times. A step back is taken out of them, since time never runs
/// backwards there; from then on it is the device's with that much added.
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
    [[nodiscard]] std::uint64_t sequenceGaps() const { return m_sequenceGaps; }
    [[nodiscard]] std::uint64_t clockSteps() const { return m_clockSteps; }
    [[nodiscard]] std::uint64_t duplicateReports() const { return m_duplicateReports; }

private:
    /// Takes the time of a report with samples; whether the clock stepped in front of it.
    bool followClock(const StreamReport& report);

    double m_forcePerCount, m_positionPerCount, m_sampleTime_s;
    bool m_started = false;
    std::uint32_t m_lastReport = 0;
    std::uint64_t m_nextSample = 0; ///< the sequence number that should come next
    std::uint64_t m_time_us = 0;    ///< of the last report with samples, on a clock that never wraps
    std::uint32_t m_stamp_us = 0;   ///< the same as the device sent it
    std::optional<std::uint64_t> m_stampedSample; ///< the sample it belongs to
    std::uint8_t m_stampedCount = 0;              ///< samples in that report
    std::uint64_t m_lostSamples = 0, m_sequenceGaps = 0;
    std::uint64_t m_duplicateReports = 0;
    std::uint64_t m_clockSteps = 0;
};

} // namespace gripscope::protocol
