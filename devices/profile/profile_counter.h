// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"

namespace gripscope {

/// Follows the counter and the clock of a profiled gripper from report to report: a number and a time for
/// every sample that never wrap, and what went missing between.
///
/// Either may come round quickly (a byte counts 256 reports), so the one that takes longer to come round says
/// how often the other one did. Reports come in order or twice. A gripper that has only a clock is counted
/// by it, in whole reports; one that has neither is taken to lose nothing.
///
/// Where counter and clock contradict each other (stepsContradict()) the clock was set. A step forward stays
/// in the times; a step back is taken out of them, since time never runs backwards there.
class ProfileCounter {
public:
    enum class Outcome {
        Accepted,
        Duplicate,
        Restarted,   ///< counter or clock went back: the device began anew
        Inconsistent ///< it counts samples, but fewer than the reports carry: the profile is wrong
    };
    struct Place {
        std::uint64_t firstSample = 0;
        double time_s = 0;         ///< of that sample
        bool clockStepped = false; ///< in front of it
    };

    explicit ProfileCounter(const GripperProfile& profile);
    ProfileCounter(const ProfileCounter&) = delete; // it points into itself
    ProfileCounter& operator=(const ProfileCounter&) = delete;

    /// Where the report's samples are; `place` is set when Accepted. The report has the profile's length.
    [[nodiscard]] Outcome take(protocol::ReportView report, Place& place);

    [[nodiscard]] std::uint64_t lostSamples() const { return m_lostSamples; }
    [[nodiscard]] std::uint64_t sequenceGaps() const { return m_sequenceGaps; }
    [[nodiscard]] std::uint64_t clockSteps() const { return m_clockSteps; }
    [[nodiscard]] std::uint64_t duplicateReports() const { return m_duplicateReports; }

private:
    /// A number that comes round: how far it went, and how much one count and one round mean.
    struct Wheel {
        const ProfileField* field = nullptr; ///< null: there is none
        double secondsPerCount = 0;
        std::uint64_t round = 0;   ///< counts in a round
        std::uint64_t behind = 0;  ///< counts back within which a report is an old one
        bool tellsRestart = false; ///< a round is long enough to tell back from far ahead
        std::uint32_t last = 0;

        [[nodiscard]] double roundSeconds() const;
        [[nodiscard]] std::uint64_t ahead(std::uint32_t now) const { return (now - last) & (round - 1); }
        /// `ahead` and as many rounds more as come nearest to `seconds`.
        [[nodiscard]] std::uint64_t aheadNear(std::uint32_t now, double seconds) const;
    };

    [[nodiscard]] static Wheel makeWheel(const ProfileField& field, double secondsPerCount, double report_s);
    void start(protocol::ReportView report);
    [[nodiscard]] bool clockLeads() const { return m_clock.roundSeconds() > m_sequence.roundSeconds(); }
    /// Accepted, or why not, by this one alone.
    [[nodiscard]] static Outcome judge(const Wheel& wheel, std::uint32_t now);
    [[nodiscard]] Outcome judge(std::uint32_t sequence, std::uint32_t clock) const;
    [[nodiscard]] Outcome advance(protocol::ReportView report);
    /// Samples since the report before, by counter and clock together.
    [[nodiscard]] std::uint64_t samplesAhead(std::uint32_t sequence, std::uint32_t clock) const;
    /// Takes the time of a report that is `step` samples on; whether the clock was set before it.
    bool followClock(std::uint64_t step, std::uint32_t clock);

    GripperProfile m_profile; ///< the wheels point into it
    Wheel m_sequence, m_clock;
    std::uint64_t m_samplesPerCount = 1; ///< of the counter
    bool m_started = false;
    std::uint64_t m_firstSample = 0;
    std::uint64_t m_ticks = 0;   ///< of the clock, without wraps
    bool m_clockStepped = false; ///< in front of the last report
    std::uint64_t m_lostSamples = 0, m_sequenceGaps = 0, m_clockSteps = 0, m_duplicateReports = 0;
};

} // namespace gripscope
