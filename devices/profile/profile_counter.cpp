// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/sample_clock.h"
#include "devices/profile/profile_codec.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {
constexpr std::uint64_t furthestProfileDuplicate = 64; ///< as many reports as the kernel's ring holds
constexpr double shareOfRound = 1.0 / 16; ///< what of a round may be taken for reports that came twice
/// Below a minute a number that is half a round ahead is as likely after a loss as after a restart.
constexpr double restartRound_s = 60;
} // namespace

double ProfileCounter::Wheel::roundSeconds() const
{
    return field ? static_cast<double>(round) * secondsPerCount : 0;
}

std::uint64_t ProfileCounter::Wheel::aheadNear(std::uint32_t now, double seconds) const
{
    const auto least = static_cast<double>(ahead(now));
    const double rounds = std::round((seconds / secondsPerCount - least) / static_cast<double>(round));
    return ahead(now) + static_cast<std::uint64_t>(std::max(0.0, rounds)) * round;
}

ProfileCounter::Wheel ProfileCounter::makeWheel(const ProfileField& field, double secondsPerCount,
                                                double report_s)
{
    Wheel wheel;
    wheel.field = &field;
    wheel.secondsPerCount = secondsPerCount;
    wheel.round = std::uint64_t(1) << field.width();
    const double duplicates =
        std::min(static_cast<double>(furthestProfileDuplicate) * report_s / secondsPerCount,
                 shareOfRound * static_cast<double>(wheel.round));
    wheel.behind = static_cast<std::uint64_t>(duplicates);
    wheel.tellsRestart = wheel.roundSeconds() >= restartRound_s;
    return wheel;
}

ProfileCounter::ProfileCounter(const GripperProfile& profile) : m_profile(profile)
{
    const double report_s = m_profile.reportTime_s();
    if (m_profile.sequence) {
        m_samplesPerCount = m_profile.sequence->countsSamples ? 1 : m_profile.samples;
        m_sequence = makeWheel(m_profile.sequence->field,
                               static_cast<double>(m_samplesPerCount) * m_profile.sampleTime_s(), report_s);
    }
    if (m_profile.clockIsFine())
        m_clock = makeWheel(m_profile.time->field, m_profile.time->secondsPerCount(), report_s);
}

void ProfileCounter::start(protocol::ReportView report)
{
    m_started = true;
    if (m_sequence.field) {
        m_sequence.last = m_sequence.field->count(report);
        m_firstSample = m_sequence.last * m_samplesPerCount;
    }
    if (m_clock.field)
        m_ticks = m_clock.last = m_clock.field->count(report);
}

ProfileCounter::Outcome ProfileCounter::judge(const Wheel& wheel, std::uint32_t now)
{
    const std::uint64_t ahead = wheel.ahead(now);
    if (ahead == 0 || wheel.round - ahead <= wheel.behind)
        return Outcome::Duplicate;
    return wheel.tellsRestart && ahead >= wheel.round / 2 ? Outcome::Restarted : Outcome::Accepted;
}

ProfileCounter::Outcome ProfileCounter::judge(std::uint32_t sequence, std::uint32_t clock) const
{
    const Outcome leading = clockLeads() ? judge(m_clock, clock) : judge(m_sequence, sequence);
    // A clock that went back while the counter went on was set.
    const bool clockAlone = !m_sequence.field || !clockLeads();
    return leading == Outcome::Accepted || clockAlone ? leading : judge(m_sequence, sequence);
}

std::uint64_t ProfileCounter::samplesAhead(std::uint32_t sequence, std::uint32_t clock) const
{
    const double elapsed_s =
        m_clock.field ? static_cast<double>(m_clock.ahead(clock)) * m_clock.secondsPerCount : 0;
    const double report_s = m_profile.reportTime_s();
    if (!m_sequence.field) // a clock that jitters by half a report's time still tells one from two
        return m_profile.samples *
               static_cast<std::uint64_t>(std::max(1.0, std::round(elapsed_s / report_s)));
    const std::uint64_t step = m_sequence.ahead(sequence) * m_samplesPerCount;
    if (!clockLeads() || m_clock.ahead(clock) >= m_clock.round / 2) // it went back
        return step;
    // Rounds of the counter are believed only when the time then fits: else it is the clock that jumped.
    const std::uint64_t rounds = m_sequence.aheadNear(sequence, elapsed_s) * m_samplesPerCount;
    constexpr double drift = 2e-4; // of the clock against the sampling, both by crystals
    const double misfit_s = std::abs(static_cast<double>(rounds) * m_profile.sampleTime_s() - elapsed_s);
    return misfit_s <= 2 * report_s + drift * elapsed_s ? rounds : step;
}

bool ProfileCounter::followClock(std::uint64_t step, std::uint32_t clock)
{
    const double sample_s = m_profile.sampleTime_s();
    const double step_s = static_cast<double>(step) * sample_s;
    const std::uint64_t ahead = clockLeads() ? m_clock.ahead(clock) : m_clock.aheadNear(clock, step_s);
    m_clock.last = clock;
    const bool back = clockLeads() && ahead >= m_clock.round / 2;
    const double elapsed_s = back ? -1 : static_cast<double>(ahead) * m_clock.secondsPerCount;
    const bool stepped = m_sequence.field && stepsContradict(elapsed_s / sample_s, static_cast<double>(step));
    // The samples of the last report reach this far; what comes now must be later.
    const bool forward = elapsed_s > static_cast<double>(m_profile.samples - 1) * sample_s;
    m_ticks += stepped && !forward
                   ? static_cast<std::uint64_t>(std::llround(step_s / m_clock.secondsPerCount))
                   : ahead;
    return stepped;
}

ProfileCounter::Outcome ProfileCounter::advance(protocol::ReportView report)
{
    const std::uint32_t sequence = m_sequence.field ? m_sequence.field->count(report) : 0;
    const std::uint32_t clock = m_clock.field ? m_clock.field->count(report) : 0;
    std::uint64_t step = m_profile.samples;
    if (m_sequence.field || m_clock.field) {
        const Outcome outcome = judge(sequence, clock);
        if (outcome != Outcome::Accepted)
            return outcome;
        step = samplesAhead(sequence, clock);
    }
    if (step == 0)
        return Outcome::Duplicate; // the clock went on, the counter did not: nothing new was sampled
    if (step < m_profile.samples)
        return Outcome::Inconsistent;
    m_lostSamples += step - m_profile.samples;
    m_sequenceGaps += step > m_profile.samples ? 1 : 0;
    m_firstSample += step;
    m_sequence.last = sequence;
    m_clockStepped = m_clock.field && followClock(step, clock);
    m_clockSteps += m_clockStepped ? 1 : 0;
    return Outcome::Accepted;
}

ProfileCounter::Outcome ProfileCounter::take(protocol::ReportView report, Place& place)
{
    const Outcome outcome = m_started ? advance(report) : Outcome::Accepted;
    if (!m_started)
        start(report);
    if (outcome == Outcome::Duplicate)
        ++m_duplicateReports;
    if (outcome == Outcome::Accepted)
        place = {m_firstSample,
                 m_clock.field ? static_cast<double>(m_ticks) * m_clock.secondsPerCount
                               : static_cast<double>(m_firstSample) * m_profile.sampleTime_s(),
                 m_clockStepped};
    return outcome;
}

} // namespace gripscope
