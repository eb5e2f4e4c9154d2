// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/sample_clock.h"

#include "core/math/robust_statistics.h"
#include "core/math/value_lattice.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double contradiction = 0.7;          ///< samples; jitter of a quarter at both ends stays below
constexpr double contradictionOfLength = 0.01; ///< of a gap, which a bad nominal clock explains
constexpr std::int64_t longestCountedGap = 50;
constexpr double mostClockSteps = 9e15; ///< still exact in a double
/// Fewer stamps do not tell a drift from jitter.
constexpr std::size_t fewestForDrift = 20;

/// A step of the grid between two samples; `timed`: the clock's own step counts.
struct Step {
    std::int64_t samples = 1;
    bool timed = true;
    bool contradicts = false;
};

double median(const std::vector<double>& values)
{
    return quantile(values, 0.5);
}

/// The sample time to count with: the mean of the steps that are one sample long, found about their median;
/// about the whole part of it nearest to the nominal time where most samples are lost.
double referenceTime(std::span<const double> time_s, std::span<const std::uint64_t> sequence,
                     double nominal_s)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        const double step = time_s[i] - time_s[i - 1];
        const bool next = sequence.empty() || sequence[i] == sequence[i - 1] + 1;
        if (step > 0 && next)
            steps.push_back(step);
    }
    const double middle = steps.empty() ? nominal_s : median(steps);
    const double times = sequence.empty() ? std::max(std::round(middle / nominal_s), 1.0) : 1.0;
    const double about = middle / times;
    double sum = 0, count = 0;
    for (const double step : steps) {
        if (std::abs(step - about) > about / 2)
            continue;
        sum += step / about - 1;
        count += 1;
    }
    const double reference = about * (1 + (count > 0 ? sum / count : 0));
    return std::isfinite(reference) && reference > 0 ? reference : nominal_s;
}

/// Follows the clock from sample to sample, so that each is counted against where the next one is due and not
/// against the jitter of the one before: a second-order loop, critically damped, over some twenty samples.
class PhaseTracker {
public:
    /// The steps of the grid up to a sample `elapsed` sample times behind the one before.
    [[nodiscard]] double due(double elapsed) const { return (elapsed + m_lead) / m_rate; }
    void follow(double elapsed, double samples)
    {
        constexpr double phaseGain = 0.1, rateGain = 0.0025;
        if (samples > static_cast<double>(longestCountedGap) || !(elapsed > 0)) {
            m_lead = 0;
            return;
        }
        const double late = elapsed + m_lead - samples * m_rate;
        m_lead = (1 - phaseGain) * late;
        m_rate = std::clamp(m_rate + rateGain * late / samples, 0.5, 2.0);
    }

private:
    double m_lead = 0; ///< how much later than the grid the last sample was
    double m_rate = 1;
};

Step countStep(double timeSteps, bool hasSequence, std::uint64_t before, std::uint64_t after)
{
    const double rounded = std::clamp(std::round(timeSteps), 1.0, mostClockSteps);
    const auto byTime = static_cast<std::int64_t>(rounded);
    const bool forward = timeSteps > 0;
    if (!hasSequence) {
        if (!forward)
            return {1, false, true};
        return {byTime, byTime <= longestCountedGap, false};
    }
    const double bySequence = after > before ? static_cast<double>(after - before) : 0;
    if (forward && bySequence > 0 && !stepsContradict(timeSteps, bySequence))
        return {static_cast<std::int64_t>(std::min(bySequence, mostClockSteps)), true, false};
    return {1, false, true};
}

double meanOver(const std::vector<double>& values, std::size_t first, std::size_t end)
{
    double sum = 0;
    for (std::size_t i = first; i < end; ++i)
        sum += values[i];
    return sum / static_cast<double>(end - first);
}

/// A sample that is late by half a sample time looks like a loss and leaves all behind it one too early. Ten
/// samples on either side of each gap tell: their phases differ by less than half a sample, or by a slip.
/// `clock.time` is the time less the index.
void takeBackSlips(SampleClock& clock, const std::vector<std::size_t>& starts)
{
    constexpr std::size_t reach = 10, fewest = 3;
    std::size_t stretch = 0;
    for (std::size_t i = 1; i < clock.index.size(); ++i) {
        const bool isLast = stretch + 1 == starts.size();
        if (!isLast && i == starts[stretch + 1]) {
            ++stretch;
            continue;
        }
        const std::int64_t step = clock.index[i] - clock.index[i - 1];
        const std::size_t first = starts[stretch];
        const std::size_t end = isLast ? clock.index.size() : starts[stretch + 1];
        if (step == 1 || i < first + fewest || i + fewest > end)
            continue;
        const double jump = meanOver(clock.time, i, std::min(i + reach, end)) -
                            meanOver(clock.time, i > first + reach ? i - reach : first, i);
        const double slip = std::round(jump);
        if (slip == 0 || static_cast<double>(step) + slip < 1)
            continue;
        for (std::size_t j = i; j < clock.index.size(); ++j) {
            clock.index[j] += static_cast<std::int64_t>(slip);
            clock.time[j] -= j < end ? slip : 0;
        }
    }
}

/// Samples [first, end) between steps that the clock does not time, with their means.
struct ClockStretch {
    std::size_t first = 0, end = 0;
    double meanIndex = 0, meanDeviation = 0;
};

std::vector<ClockStretch> timedStretches(const SampleClock& clock, const std::vector<std::size_t>& starts)
{
    std::vector<ClockStretch> stretches;
    for (std::size_t s = 0; s < starts.size(); ++s) {
        ClockStretch stretch;
        stretch.first = starts[s];
        stretch.end = s + 1 < starts.size() ? starts[s + 1] : clock.index.size();
        const auto count = static_cast<double>(stretch.end - stretch.first);
        for (std::size_t i = stretch.first; i < stretch.end; ++i) {
            stretch.meanIndex += static_cast<double>(clock.index[i]) / count;
            stretch.meanDeviation += clock.time[i] / count;
        }
        stretches.push_back(stretch);
    }
    return stretches;
}

/// Least squares of time on index, with one slope and an offset for each stretch. In: clock.time less the
/// index, for the reference time (so that long records lose no digits); out: clock.time.
void fitLines(SampleClock& clock, const std::vector<ClockStretch>& stretches, double reference_s)
{
    double squares = 0, products = 0;
    for (const ClockStretch& stretch : stretches) {
        for (std::size_t i = stretch.first; i < stretch.end; ++i) {
            const double index = static_cast<double>(clock.index[i]) - stretch.meanIndex;
            squares += index * index;
            products += index * (clock.time[i] - stretch.meanDeviation);
        }
    }
    // The slope less 1; times that hardly go on are no clock.
    constexpr double slowest = -0.9;
    const double slope = squares > 0 ? products / squares : 0;
    const double excess = slope > slowest && std::isfinite(slope) ? slope : 0;
    double sse = 0, largest = 0;
    for (const ClockStretch& stretch : stretches) {
        for (std::size_t i = stretch.first; i < stretch.end; ++i) {
            const double index = static_cast<double>(clock.index[i]) - stretch.meanIndex;
            const double rest = (clock.time[i] - stretch.meanDeviation - excess * index) / (1 + excess);
            sse += rest * rest;
            largest = std::max(largest, std::abs(rest));
            clock.time[i] = static_cast<double>(clock.index[i]) + rest;
        }
    }
    const auto count = static_cast<double>(clock.index.size());
    const double free = count - static_cast<double>(stretches.size()) - 1;
    clock.sampleTime_s = reference_s * (1 + excess);
    clock.jitter = std::sqrt(sse / count);
    clock.driftError = free > 0 && squares > 0 ? std::sqrt(sse / free / squares) : 0;
    // Rounding moves a stamp by half a lattice step, and the fitted line by a little.
    clock.jittered = clock.jitter > smallestJitter && !(largest <= 0.75 * clock.resolution);
}

void countGaps(SampleClock& clock, std::int64_t acrossBreak)
{
    for (std::size_t i = 1; i < clock.index.size(); ++i) {
        const std::int64_t missing = clock.index[i] - clock.index[i - 1] - 1;
        if (missing == 0 || (clock.breaks > 0 && missing + 1 == acrossBreak))
            continue;
        ++clock.gaps;
        clock.lost += missing;
    }
}

} // namespace

bool stepsContradict(double timeSteps, double sequenceSteps)
{
    return std::abs(timeSteps - sequenceSteps) >
           std::max(contradiction, contradictionOfLength * sequenceSteps);
}

SampleClock readSampleClock(std::span<const double> time_s, std::span<const std::uint64_t> sequence,
                            double nominal_s)
{
    SampleClock clock;
    clock.sampleTime_s = nominal_s;
    clock.index.assign(time_s.size(), 0);
    clock.time.assign(time_s.size(), 0.0);
    if (time_s.size() < 2)
        return clock;
    const double reference_s = referenceTime(time_s, sequence, nominal_s);
    PhaseTracker tracker;
    std::vector<std::size_t> starts{0};
    // No share of lost samples bridges as many as this.
    const auto acrossBreak =
        static_cast<std::int64_t>(std::min(1000 * static_cast<double>(time_s.size()), mostClockSteps));
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        const double timeSteps = (time_s[i] - time_s[i - 1]) / reference_s;
        const double due = timeSteps > 0 ? std::max(tracker.due(timeSteps), 0.5) : 0;
        const Step step = sequence.empty() ? countStep(due, false, 0, 0)
                                           : countStep(timeSteps, true, sequence[i - 1], sequence[i]);
        const std::int64_t room = static_cast<std::int64_t>(mostClockSteps) - clock.index[i - 1];
        const std::int64_t samples =
            std::min(step.contradicts ? acrossBreak : step.samples, std::max<std::int64_t>(room, 1));
        tracker.follow(timeSteps, static_cast<double>(samples));
        clock.index[i] = clock.index[i - 1] + samples;
        clock.time[i] = step.timed ? clock.time[i - 1] + (timeSteps - static_cast<double>(samples)) : 0;
        if (!step.timed)
            starts.push_back(i);
        clock.breaks += step.contradicts ? 1 : 0;
    }
    if (sequence.empty())
        takeBackSlips(clock, starts);
    countGaps(clock, acrossBreak);
    if (const std::optional<double> lattice = latticeStep(time_s))
        clock.resolution = *lattice / reference_s;
    fitLines(clock, timedStretches(clock, starts), reference_s);
    clock.drift = clock.sampleTime_s / nominal_s - 1;
    clock.drifts =
        time_s.size() >= fewestForDrift && std::abs(clock.drift) > std::max(5 * clock.driftError, 1e-6);
    if (!clock.drifts)
        clock.sampleTime_s = nominal_s;
    return clock;
}

} // namespace gripscope
