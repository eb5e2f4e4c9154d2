// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/quasistatic/held_stiffness.h"

#include "core/base/words.h"
#include "core/identification/model/identifiability.h"
#include "core/math/normal_interval.h"
#include "core/signal/recording/channel_quantity.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace gripscope {

namespace {

constexpr double lowerForceShare = 0.05, upperForceShare = 0.9;

struct Range {
    double least = 0, most = 0;
};

/// Where the loading passes its two forces.
struct Loading {
    Range force;
    double from_s = 0, to_s = 0;
};

double crossing(const HeldPosition& held, std::size_t above, double force)
{
    const double low = held.force[above - 1], high = held.force[above];
    const double share = high > low ? std::clamp((force - low) / (high - low), 0.0, 1.0) : 1;
    return held.time_s[above - 1] + share * (held.time_s[above] - held.time_s[above - 1]);
}

/// There are samples before contact; one whose force is not below F1 already makes F1 its own.
Loading loadingOf(const HeldPosition& held)
{
    const auto first = held.force.begin() + static_cast<std::ptrdiff_t>(held.contact.first);
    const auto last = first + static_cast<std::ptrdiff_t>(held.contact.count);
    const double largest = *std::max_element(first, last);
    Loading loading;
    loading.force = {lowerForceShare * largest, upperForceShare * largest};
    std::size_t to = held.contact.first;
    while (held.force[to] < loading.force.most)
        ++to;
    std::size_t from = to;
    while (from > 1 && held.force[from - 1] > loading.force.least)
        --from;
    loading.force.least = std::max(loading.force.least, held.force[from - 1]);
    loading.from_s = crossing(held, from, loading.force.least);
    loading.to_s = crossing(held, to, loading.force.most);
    return loading;
}

Range hull(double value, const Range& range)
{
    return {std::min(value, range.least), std::max(value, range.most)};
}

/// For every sample what the position may be there: from what the channel shows to the next value that
/// stands.
std::vector<Range> possiblePositions(const std::vector<double>& position)
{
    std::vector<Range> possible(position.size());
    Range ahead{position.back(), position.back()}; // all that follows up to the next that stands
    for (std::size_t end = position.size(); end > 0;) {
        const double value = position[end - 1];
        std::size_t first = end - 1;
        while (first > 0 && position[first - 1] == value)
            --first;
        const Range here = hull(value, ahead);
        for (std::size_t i = first; i < end; ++i)
            possible[i] = here;
        ahead = end - first > 1 ? Range{value, value} : here;
        end = first;
    }
    return possible;
}

/// What the position may be at a time between two samples; the record covers it.
Range possibleAt(const HeldPosition& held, const std::vector<Range>& possible, double time_s)
{
    const auto after = std::ranges::upper_bound(held.time_s, time_s);
    const auto next = static_cast<std::size_t>(std::min(after, held.time_s.end() - 1) - held.time_s.begin());
    const Range& a = possible[next > 0 ? next - 1 : 0];
    const Range& b = possible[next];
    return {std::min(a.least, b.least), std::max(a.most, b.most)};
}

/// The travel over the loading, whatever the clocks; nothing where the record is too short to tell.
std::optional<Range> possibleTravel(const HeldPosition& held, const Loading& loading)
{
    const double first = held.clockOffset_s - held.clockBound_s;
    const double last = held.clockOffset_s + held.clockBound_s;
    if (loading.from_s + first < held.time_s.front() || loading.to_s + last > held.time_s.back())
        return std::nullopt;
    const std::vector<Range> possible = possiblePositions(held.position);
    // The ranges change from sample to sample only, and overlap by one: steps of a quarter miss none.
    const double sampleTime_s =
        (held.time_s.back() - held.time_s.front()) / static_cast<double>(held.time_s.size() - 1);
    const auto steps = static_cast<int>(std::ceil(std::min(4 * (last - first) / sampleTime_s, 1e5)));
    Range travel{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (int i = 0; i <= steps; ++i) {
        const double clock_s = first + (last - first) * i / std::max(steps, 1);
        const Range from = possibleAt(held, possible, loading.from_s + clock_s);
        const Range to = possibleAt(held, possible, loading.to_s + clock_s);
        travel.least = std::min(travel.least, to.least - from.most);
        travel.most = std::max(travel.most, to.most - from.least);
    }
    return travel;
}

Finding forceIn(const HeldPosition& held, double force)
{
    return channelQuantity(MechanicalQuantity::Force, force, held.forceUnit);
}

Finding stiffnessIn(const HeldPosition& held, double k)
{
    if (const std::optional<double> si = siFactor(held.forceUnit, held.positionUnit))
        return Finding::quantity(MechanicalQuantity::Stiffness, k * *si);
    const QString unit = parameterUnits(held.forceUnit, held.positionUnit).k;
    const Finding number = Finding::number(k, 'g', 3);
    return unit == QLatin1String("1") ? number : number + Finding(u' ' + unit);
}

Finding ofWhat(bool frameIsKnown)
{
    return frameIsKnown ? Words::say("It is that of the part")
                        : Words::say("It is that of the part and the fingers together");
}

Finding boundsWords(const HeldPosition& held, const Loading& loading, const StiffnessBounds& bounds,
                    bool frameIsKnown)
{
    const Finding lower = stiffnessIn(held, bounds.lower);
    const Finding from = forceIn(held, loading.force.least), to = forceIn(held, loading.force.most);
    if (bounds.upper)
        return Words::say("k is between %1 and %2 while the force rises from %3 to %4, whatever the position "
                          "does between its renewals and with clocks that are apart by up to %5 s. %6")
            .arg(lower, stiffnessIn(held, *bounds.upper), from, to)
            .arg(held.clockBound_s, 'g', 2)
            .arg(ofWhat(frameIsKnown));
    return Words::say(
               "k is at least %1 while the force rises from %2 to %3, which takes %4 s: with clocks that "
               "may be apart by up to %5 s, the part is not told from a rigid one. %6")
        .arg(lower, from, to)
        .arg(loading.to_s - loading.from_s, 'g', 2)
        .arg(held.clockBound_s, 'g', 2)
        .arg(ofWhat(frameIsKnown));
}

/// A spring alone, in the middle of its bounds.
MotionEstimate springBetween(double lower, double upper)
{
    MotionEstimate spring;
    spring.terms = MotionTerms{.mass = false, .damping = false};
    const double k = std::sqrt(lower) * std::sqrt(upper);
    const double deviation = k * (std::log(upper) - std::log(lower)) / 2 / std::numbers::sqrt3;
    spring.values[MotionParameter::Stiffness] = k;
    spring.covariance = Eigen::MatrixXd::Constant(1, 1, deviation * deviation);
    return spring;
}

Estimate unknownStiffness(const Finding& why)
{
    return statusOnly(Estimator::Static, EstimateStatus::NotIdentifiable, why);
}

} // namespace

Estimate estimateHeldStiffness(const HeldPosition& held, const MeasuringChain& chain)
{
    const Loading loading = loadingOf(held);
    const std::optional<Range> measured = possibleTravel(held, loading);
    const Finding from = forceIn(held, loading.force.least), to = forceIn(held, loading.force.most);
    if (!measured)
        return unknownStiffness(
            Words::say(
                "k is not told while the force rises from %1 to %2: the clocks may be apart by up to %3 "
                "s, and the record does not reach as far before or behind that. Record longer")
                .arg(from, to)
                .arg(held.clockBound_s, 'g', 2));
    const double rise = loading.force.most - loading.force.least;
    const double noise = normal95 * std::numbers::sqrt2 * held.forceNoise;
    const double spread = normal95 * std::abs(chain.frameComplianceUncertainty) * rise;
    const Range travel{measured->least - chain.frameCompliance * rise - spread,
                       measured->most - chain.frameCompliance * rise + spread};
    StiffnessBounds bounds{(rise - noise) / travel.most, {}};
    if (!(bounds.lower > 0) || !std::isfinite(bounds.lower))
        return unknownStiffness(
            Words::say(
                "k is not told: the position does not close while the force rises from %1 to %2. Check "
                "which column is which, and the grip")
                .arg(from, to));
    const bool frameIsKnown = chain.frameCompliance != 0 || chain.frameComplianceUncertainty != 0;
    const double upper = (rise + noise) / travel.least;
    const bool told = travel.least >= leastTravelShare * travel.most && std::isfinite(upper);
    if (told)
        bounds.upper = upper;
    Estimate estimate = unknownStiffness(boundsWords(held, loading, bounds, frameIsKnown));
    estimate.stiffnessBounds = bounds;
    if (!told)
        return estimate;
    estimate.status = EstimateStatus::Converged;
    estimate.motion = springBetween(bounds.lower, upper);
    return estimate;
}

Estimate notOfHeldPosition(Estimator estimator, const HeldPosition& held)
{
    return statusOnly(
        estimator, EstimateStatus::NotApplicable,
        Words::say("the position is renewed only every %1 s, so that no motion is in it: mass and damping "
                   "cannot be had. Sample force and position by one clock, faster than the part swings; the "
                   "stiffness alone is told by static")
            .arg(held.interval_s, 'g', 2));
}

} // namespace gripscope
