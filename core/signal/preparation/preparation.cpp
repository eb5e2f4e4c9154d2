// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/preparation.h"

#include "core/math/normal_interval.h"
#include "core/math/value_lattice.h"
#include "core/signal/preparation/preparation_parts.h"
#include "core/signal/preparation/sample_clock.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

template <typename T>
std::span<const T> viewOf(const std::vector<T>& all, Window window)
{
    return std::span<const T>(all).subspan(window.first, window.count);
}

bool allFinite(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool isUsable(const Recording& recording)
{
    const std::size_t n = recording.size();
    return recording.position.size() == n && recording.time_s.size() == n &&
           std::isfinite(recording.sampleTime_s) && recording.sampleTime_s > 0 &&
           std::isfinite(recording.forceLag_s) && allFinite(recording.force) &&
           allFinite(recording.position) && allFinite(recording.time_s);
}

/// Where the position is held: the squeeze with all around it, and what is known of its clocks.
std::optional<HeldPosition> heldSqueeze(const Recording& recording, Window asked)
{
    std::optional<HeldPosition> held = heldPosition(
        viewOf(recording.time_s, asked), viewOf(recording.force, asked), viewOf(recording.position, asked));
    if (!held)
        return std::nullopt;
    held->forceUnit = recording.forceUnit;
    held->positionUnit = recording.positionUnit;
    if (lagIsStated(recording)) {
        held->clockOffset_s = -recording.forceLag_s;
        held->clockBound_s = normal95 * std::abs(recording.chain.forceLagUncertainty_s);
    }
    return held;
}

ContactPhases phasesOf(const HeldPosition& held)
{
    ContactPhases phases;
    phases.hasApproach = true;
    phases.touch = phases.loaded = held.contact.first;
    phases.squeeze = held.contact;
    phases.hasRelease = held.contact.first + held.contact.count < held.force.size();
    return phases;
}

/// The phases within the part asked for, and whether the position is held or an opening.
ContactPhases readPhases(PreparedRecord& prepared, const Recording& recording, Window asked)
{
    const auto force = viewOf(recording.force, asked), position = viewOf(recording.position, asked);
    prepared.held = heldSqueeze(recording, asked);
    if (prepared.held) {
        if (prepared.held->opening)
            prepared.steps.push_back(openingStep(asked.count));
        if (prepared.held->spikes > 0)
            prepared.steps.push_back(spikesStep(*prepared.held));
        return phasesOf(*prepared.held);
    }
    const ContactPhases phases = findContact(force, position);
    if (phases.hasApproach || phases.hasRelease)
        return phases;
    const std::optional<ContactPhases> opening = findOpening(force, position);
    if (opening)
        prepared.steps.push_back(openingStep(asked.count));
    return opening.value_or(phases);
}

/// The squeeze's samples within the part the device calls one.
Window chooseSqueeze(PreparedRecord& prepared, const Recording& recording, const PreparationOptions& options)
{
    const Window asked = movingWindow(recording);
    prepared.phases = {};
    prepared.phases.touch = prepared.phases.loaded = asked.first;
    prepared.phases.squeeze = asked;
    if (!options.findContact)
        return asked;
    ContactPhases phases = readPhases(prepared, recording, asked);
    phases.touch += asked.first;
    phases.loaded += asked.first;
    phases.squeeze.first += asked.first;
    prepared.phases = phases;
    if (phases.squeeze.count < asked.count)
        prepared.steps.push_back(contactStep(phases, asked));
    return phases.squeeze;
}

SampleClock readClock(PreparedRecord& prepared, const Recording& recording, Window squeeze)
{
    const bool numbered = recording.sequence.size() == recording.size();
    const std::span<const std::uint64_t> sequence =
        numbered ? viewOf(recording.sequence, squeeze) : std::span<const std::uint64_t>();
    SampleClock clock = readSampleClock(viewOf(recording.time_s, squeeze), sequence, recording.sampleTime_s);
    prepared.sampleTime_s = clock.sampleTime_s;
    prepared.choice.eligible = squeeze.count;
    prepared.choice.lostSamples = clock.lost;
    prepared.choice.gaps = clock.gaps;
    if (clock.drifts)
        prepared.steps.push_back(driftStep(clock, recording.sampleTime_s));
    if (clock.breaks > 0)
        prepared.steps.push_back(breakStep(clock));
    return clock;
}

/// The device's stamps where it measured; where samples were moved or are missing, the grid's own times.
std::vector<double> gridTimes(const Recording& recording, Window used, const SampleClock& clock,
                              std::size_t clockFirst, std::size_t points, bool moved)
{
    std::vector<double> time_s(points);
    const std::int64_t origin = clock.index[clockFirst];
    const double offset =
        static_cast<double>(origin) - (moved ? clock.time[clockFirst] : static_cast<double>(origin));
    const double start_s = recording.time_s[used.first] + offset * clock.sampleTime_s;
    for (std::size_t n = 0; n < points; ++n)
        time_s[n] = start_s + static_cast<double>(n) * clock.sampleTime_s;
    for (std::size_t i = 0; i < used.count && !moved; ++i)
        time_s[static_cast<std::size_t>(clock.index[clockFirst + i] - origin)] =
            recording.time_s[used.first + i];
    return time_s;
}

/// Force and position on the grid; returns the samples used.
Window fillGrid(PreparedRecord& prepared, const Recording& recording, Window squeeze,
                const PreparationOptions& options)
{
    const SampleClock clock = readClock(prepared, recording, squeeze);
    const Window kept = keepLostShare(clock.index, std::clamp(options.largestLostShare, 0.01, 0.99));
    const Window used{squeeze.first + kept.first, kept.count};
    const auto index = viewOf(clock.index, kept);
    const auto time = viewOf(clock.time, kept);
    const bool moved = options.resample && clock.jittered;
    const ForceHold hold = options.hold.value_or(recording.hold.value_or(ForceHold::First));
    GriddedChannels grid =
        moved ? resampleToGrid(viewOf(recording.force, used), viewOf(recording.position, used), index, time,
                               hold)
              : placeOnGrid(viewOf(recording.force, used), viewOf(recording.position, used), index);
    prepared.time_s = gridTimes(recording, used, clock, kept.first, grid.force.size(), moved);
    prepared.force = std::move(grid.force);
    prepared.position = std::move(grid.position);
    prepared.lost = std::move(grid.lost);
    if (prepared.find(u"opening"_s) != nullptr)
        for (double& x : prepared.position)
            x = -x;
    if (clock.jittered)
        prepared.steps.push_back(jitterStep(clock, moved));
    if (clock.gaps > 0)
        prepared.steps.push_back(lostStep(prepared.choice));
    if (kept.count < squeeze.count)
        prepared.steps.push_back(cutStep(used, squeeze));
    return used;
}

void exciseContactLoss(PreparedRecord& prepared)
{
    const std::vector<std::size_t> away = findContactLoss(prepared.force, prepared.position);
    if (away.empty())
        return;
    std::vector<std::size_t> lost;
    std::set_union(prepared.lost.begin(), prepared.lost.end(), away.begin(), away.end(),
                   std::back_inserter(lost));
    prepared.lost = std::move(lost);
    prepared.steps.push_back(contactLossStep(away, prepared.force.size()));
}

void removeFrame(PreparedRecord& prepared, ForceHold hold)
{
    const double compliance = prepared.chain.frameCompliance;
    if (compliance == 0 || !std::isfinite(compliance))
        return;
    prepared.position = withoutFrame(prepared.position, prepared.force, compliance,
                                     prepared.forceLag_s / prepared.sampleTime_s, hold);
    prepared.steps.push_back(frameStep(compliance));
}

/// What the force channel's noise is, from before the squeeze, unless it was stated.
void measureForceNoise(PreparedRecord& prepared, const Recording& recording)
{
    if (prepared.chain.forceNoiseDeviation > 0)
        return;
    const ContactPhases& phases = prepared.phases;
    // The last of an approach feels the object already.
    const std::size_t rest =
        phases.hasApproach ? phases.touch - phases.touch / 5 : movingWindow(recording).first;
    const std::optional<double> deviation = restingForceNoise(viewOf(recording.force, {0, rest}));
    if (!deviation)
        return;
    prepared.chain.forceNoiseDeviation = *deviation;
    prepared.steps.push_back(forceNoiseStep(rest, *deviation, recording.forceUnit));
}

void notice(PreparedRecord& prepared, const Recording& recording, Window used)
{
    if (auto step = saturationStep(recording, used, prepared.held.has_value()))
        prepared.steps.push_back(*std::move(step));
    if (prepared.held)
        prepared.steps.push_back(heldStep(*prepared.held));
    const auto positions = viewOf(recording.position, used);
    prepared.positionStep = latticeStep(positions).value_or(0);
    if (auto step = quantizationStep(positions, prepared.positionStep, recording.positionUnit))
        prepared.steps.push_back(*std::move(step));
}

/// The force `at` samples after the first one.
double forceAt(const std::vector<double>& force, double at, ForceHold hold)
{
    // A rest this close to a whole sample is rounding, not time.
    constexpr double rounding = 1e-9;
    const double last = static_cast<double>(force.size()) - 1;
    const double clamped = std::clamp(at, 0.0, last);
    const double whole = std::floor(clamped + rounding);
    const auto n = static_cast<std::size_t>(whole);
    const double rest = std::max(clamped - whole, 0.0);
    if (hold == ForceHold::Zero || rest <= rounding || n + 1 >= force.size())
        return force[n];
    return (1 - rest) * force[n] + rest * force[n + 1];
}

} // namespace

const PreparationStep* PreparedRecord::find(const QString& id) const
{
    for (const PreparationStep& step : steps) {
        if (step.id == id)
            return &step;
    }
    return nullptr;
}

PreparedRecord windowOf(const PreparedRecord& record, Window window)
{
    PreparedRecord viewOf;
    viewOf.sampleTime_s = record.sampleTime_s;
    viewOf.hold = record.hold;
    viewOf.forceLag_s = record.forceLag_s;
    viewOf.chain.friction = record.chain.friction;
    const auto cut = [&](const std::vector<double>& all) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(window.first);
        return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(window.count));
    };
    viewOf.force = cut(record.force);
    viewOf.position = cut(record.position);
    for (const std::size_t index : record.lost)
        if (index >= window.first && index < window.first + window.count)
            viewOf.lost.push_back(index - window.first);
    return viewOf;
}

PreparedRecord prepare(const Recording& recording, const PreparationOptions& options)
{
    PreparedRecord prepared;
    prepared.sampleTime_s = recording.sampleTime_s;
    prepared.hold = recording.hold;
    prepared.forceLag_s = recording.forceLag_s;
    prepared.chain = recording.chain;
    prepared.lagBound_s = unmeasuredLagBound_s(recording);
    if (!isUsable(recording)) {
        prepared.time_s = recording.time_s;
        prepared.force = recording.force;
        prepared.position = recording.position;
        prepared.choice = chooseWindow(recording);
        prepared.steps.push_back(unusableStep());
        return prepared;
    }
    if (recording.size() == 0)
        return prepared;
    const Window squeeze = chooseSqueeze(prepared, recording, options);
    measureForceNoise(prepared, recording);
    prepared.choice.window = fillGrid(prepared, recording, squeeze, options);
    if (options.findContact && !prepared.held)
        exciseContactLoss(prepared);
    if (options.removeFrame)
        removeFrame(prepared, options.hold.value_or(recording.hold.value_or(ForceHold::First)));
    notice(prepared, recording, prepared.choice.window);
    return prepared;
}

std::vector<double> withoutFrame(const std::vector<double>& position, const std::vector<double>& force,
                                 double compliance, double lag, ForceHold hold)
{
    std::vector<double> corrected = position;
    if (force.size() != position.size() || !std::isfinite(compliance) || !std::isfinite(lag))
        return corrected;
    for (std::size_t n = 0; n < corrected.size(); ++n) {
        const double x = position[n] - compliance * forceAt(force, static_cast<double>(n) + lag, hold);
        if (std::isfinite(x))
            corrected[n] = x;
    }
    return corrected;
}

std::optional<double> restingForceNoise(std::span<const double> force)
{
    if (force.size() < leastRestingSamples)
        return std::nullopt;
    const double origin = force.front();
    double squares = 0, sum = 0, sumOfSquares = 0;
    std::size_t moved = 0;
    for (std::size_t i = 1; i < force.size(); ++i) {
        const double difference = force[i] - force[i - 1], value = force[i] - origin;
        squares += difference * difference;
        moved += difference != 0 ? 1 : 0;
        sum += value;
        sumOfSquares += value * value;
    }
    const auto differences = static_cast<double>(force.size() - 1);
    const auto count = static_cast<double>(force.size());
    const double noise = squares / (2 * differences);
    const double whole = (sumOfSquares - sum * sum / count) / differences;
    if (2 * static_cast<double>(moved) < differences || !std::isfinite(noise) || !(whole <= 2 * noise))
        return std::nullopt;
    return std::sqrt(noise);
}

} // namespace gripscope
