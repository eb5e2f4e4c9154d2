// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"
#include "devices/transport/report_decoder.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

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

/// A gripper by its profile, and which one of its kind it is.
struct ProfiledDevice {
    GripperProfile profile;
    QString serial;
};

/// Samples out of the reports of another maker's gripper, by its profile. Pure: the same bytes give the same
/// samples.
class ProfileDecoder : public ReportDecoder {
public:
    /// Finds the profile; called by describe(), so that it may read files.
    using Source = std::function<Expected<ProfiledDevice>()>;
    explicit ProfileDecoder(Source source) : m_source(std::move(source)) {}
    /// For reports alone, without a device.
    explicit ProfileDecoder(const GripperProfile& profile);

    Expected<DeviceDescription> describe(Transport& transport, const QString& address) override;
    /// A report with another ID is Other; a wrong length, a number that is not finite and a counter that
    /// makes no sense are errors.
    Taken take(protocol::ReportView bytes, std::vector<Sample>& samples) override;
    [[nodiscard]] Counts counts() const override;
    [[nodiscard]] bool understandsCommands() const override { return false; }

    /// Status bits of a report, but for those of the channels.
    [[nodiscard]] static std::uint16_t statusOf(const GripperProfile& profile, protocol::ReportView report);

private:
    void use(const GripperProfile& profile);
    [[nodiscard]] bool readSamples(protocol::ReportView bytes);

    Source m_source;
    GripperProfile m_profile;
    std::unique_ptr<ProfileCounter> m_counter; ///< from describe() on
    std::vector<Sample> m_read;                ///< those of one report; kept so that nothing is allocated
};

/// The reports that a gripper with this profile sends: what ProfileDecoder undoes.
class ProfileEncoder {
public:
    struct Reading {
        double force_N = 0, position_m = 0;
        std::uint16_t status = 0; ///< SampleStatus bits; those of the whole report are what any sample has
    };

    explicit ProfileEncoder(const GripperProfile& profile);

    /// The next report, of `profile.samples` readings; its first was taken at `time_s`.
    [[nodiscard]] std::vector<std::uint8_t> encode(std::span<const Reading> readings, double time_s);

private:
    /// True: the number did not fit, or the channel says that it is at the end of its range.
    bool put(const ProfileChannel& channel, double value_SI, double siPerUnit, std::span<std::uint8_t> report,
             std::size_t shift) const;
    void putStatus(std::uint16_t status, std::span<std::uint8_t> report) const;

    GripperProfile m_profile;
    double m_newtons, m_metres; ///< in a unit of the channels
    std::uint64_t m_reports = 0;
};

} // namespace gripscope
