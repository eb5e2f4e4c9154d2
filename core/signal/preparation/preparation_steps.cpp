// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/robust_statistics.h"
#include "core/signal/preparation/preparation_parts.h"
#include "core/signal/preparation/sensor_faults.h"
#include "core/signal/recording/channel_quantity.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Above this root mean square, in sample times, neighbours begin to change places.
constexpr double largestJitter = 0.2;
/// A clock that is off by more is more likely a wrong sample time.
constexpr double largestDrift = 0.01;
/// Noise spreads rounding errors evenly: with steps below 2.5 of its standard deviations (2 of what is
/// measured, which holds the rounding too) m, b and k keep within 0.25 of their standard errors, 10,000
/// samples long. Larger ones shift them by at most 0.14 times the step's share of the range (Monte Carlo:
/// three types and a lightly damped object, binary force and multisine, 5,000 and 10,000 samples).
constexpr double noticedStep = 2;
constexpr double largestShift = 0.15;
/// Of the range: a shift of 0.5 % of m, b or k, which the other checks too begin to count.
constexpr double coarseStep = 0.03;
constexpr double finestWorthNaming = 1e-4;

Finding number(double value)
{
    return Finding::number(value, 'g', 3);
}

} // namespace

PreparationStep unusableStep()
{
    return {
        u"unusable"_s, 0, 0, false,
        Words::say(
            "the channels differ in length, or hold numbers that are not finite, or the sample time is not "
            "above zero")};
}

PreparationStep contactStep(const ContactPhases& phases, Window asked)
{
    const std::size_t before = phases.squeeze.first - asked.first;
    const std::size_t behind = asked.count - phases.squeeze.count - before;
    return {
        u"contact"_s, before + behind, static_cast<double>(phases.squeeze.count), true,
        Words::say(
            "%1 samples of approach and touch and %2 of release were left out; %3 samples of squeeze remain")
            .arg(before)
            .arg(behind)
            .arg(phases.squeeze.count)};
}

PreparationStep driftStep(const SampleClock& clock, double nominal_s)
{
    const bool ok = std::abs(clock.drift) <= largestDrift;
    Finding message =
        Words::say("the device's clock runs at %1 s a sample instead of %2 s (%3 %); its own time was used")
            .arg(clock.sampleTime_s, 'g', 9)
            .arg(nominal_s, 'g', 9)
            .arg(number(100 * clock.drift));
    if (!ok)
        message += Words::say(". That is much for a clock: check the sample time");
    return {u"clock_drift"_s, 0, clock.drift, ok, message};
}

PreparationStep breakStep(const SampleClock& clock)
{
    return {
        u"clock_break"_s, clock.breaks, static_cast<double>(clock.breaks), true,
        Words::say("time stamps and sample numbers contradict each other in %1 places: the device's clock "
                   "was set, or "
                   "the device started again. The longest part between them was used.")
            .arg(clock.breaks)};
}

PreparationStep jitterStep(const SampleClock& clock, bool moved)
{
    const bool ok = moved && clock.jitter <= largestJitter;
    const Finding share = number(100 * clock.jitter);
    if (!moved)
        return {
            u"clock_jitter"_s, 0, clock.jitter, ok,
            Words::say("the samples jitter by %1 % of the sample time and were taken as regular").arg(share)};
    Finding message =
        Words::say(
            "the samples jitter by %1 % of the sample time; force and position were put on a regular grid")
            .arg(share);
    if (!ok)
        message +=
            Words::say(". That is too much for an exact correction: let the device sample more regularly");
    return {u"clock_jitter"_s, 0, clock.jitter, ok, message};
}

PreparationStep lostStep(const WindowChoice& choice)
{
    return {u"samples_lost"_s, choice.gaps, static_cast<double>(choice.lostSamples), true,
            Words::say("%1 samples are missing in %2 places; the force there counts as unknown")
                .arg(choice.lostSamples)
                .arg(choice.gaps)};
}

PreparationStep cutStep(Window used, Window squeeze)
{
    const std::size_t left = squeeze.count - used.count;
    return {u"window_cut"_s, left, static_cast<double>(left) / static_cast<double>(squeeze.count), false,
            Words::say("too many samples are missing to bridge all gaps; %1 of the %2 samples there are were "
                       "used. Check "
                       "the cable and the load of the computer, then squeeze again.")
                .arg(used.count)
                .arg(squeeze.count)};
}

PreparationStep contactLossStep(const std::vector<std::size_t>& away, std::size_t samples)
{
    const double share = static_cast<double>(away.size()) / static_cast<double>(samples);
    return {u"contact_loss"_s, away.size(), share, true,
            Words::say("the gripper left the object for %1 samples (%2 %), since it can push but not pull; "
                       "they were left "
                       "out. Squeeze with more bias.")
                .arg(away.size())
                .arg(number(100 * share))};
}

PreparationStep forceNoiseStep(std::size_t samples, double deviation, const QString& forceUnit)
{
    return {u"force_noise"_s, samples, deviation, true,
            Words::say("the force channel's noise, %1, was taken from the %2 samples before the squeeze")
                .arg(channelQuantity(MechanicalQuantity::Force, deviation, forceUnit))
                .arg(samples)};
}

PreparationStep frameStep(double compliance)
{
    return {u"frame_compliance"_s, 0, compliance, true,
            Words::say("the frame's share of the position, %1 position units per force unit, was taken away")
                .arg(number(compliance))};
}

PreparationStep openingStep(std::size_t samples)
{
    return {u"opening"_s, samples, 0, true,
            Words::say("the position falls as the force rises: it was read as the opening between the "
                       "fingers, and its sign was turned")};
}

PreparationStep spikesStep(const HeldPosition& held)
{
    return {u"force_spikes"_s, held.spikes, held.largestSpike, true,
            Words::say("%1 samples outside of contact, where the force reads up to %2, were left out: "
                       "spikes, or another touch")
                .arg(held.spikes)
                .arg(channelQuantity(MechanicalQuantity::Force, held.largestSpike, held.forceUnit))};
}

PreparationStep heldStep(const HeldPosition& held)
{
    return {u"position_held"_s, held.contact.count, held.interval_s, false,
            Words::say("the position stands still and is renewed only every %1 s, while the force goes on")
                .arg(held.interval_s, 'g', 2)};
}

std::optional<PreparationStep> saturationStep(const Recording& recording, Window used, bool positionIsHeld)
{
    SaturatedSamples found = saturatedSamples(recording, used);
    if (positionIsHeld)
        found.position.look = {};
    const std::size_t marked = found.force.marked + found.position.marked;
    const std::size_t count = found.force.count() + found.position.count();
    if (count == 0)
        return std::nullopt;
    const double share = static_cast<double>(count) / static_cast<double>(used.count);
    return PreparationStep{
        u"saturation"_s, count, share, false,
        Words::say("samples at the end of a sensor's range: %1 by the device's word, %2 of "
                   "force and %3 of position by "
                   "their look. Squeeze with less force.")
            .arg(marked)
            .arg(found.force.look.total())
            .arg(found.position.look.total())};
}

std::optional<PreparationStep> quantizationStep(std::span<const double> positions, double step,
                                                const QString& unit)
{
    if (!(step > 0))
        return std::nullopt;
    const auto [lowest, highest] = std::minmax_element(positions.begin(), positions.end());
    const double share = step / (*highest - *lowest);
    if (share < finestWorthNaming || step < noticedStep * whiteNoiseDeviation(positions))
        return std::nullopt;
    return PreparationStep{u"quantization"_s, positions.size(), step, share < coarseStep,
                           Words::say("the position comes in steps of %1, %2 % of its range and more than "
                                      "twice its noise: m, b and k may "
                                      "be off by up to %3 %")
                               .arg(channelQuantity(MechanicalQuantity::Length, step, unit))
                               .arg(number(100 * share))
                               .arg(number(100 * largestShift * share))};
}

} // namespace gripscope
