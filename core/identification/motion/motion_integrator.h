// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/motion_terms.h"
#include "core/math/dual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace gripscope {

/// Integrates the family of MotionTerms by Taylor series of the solution (Corliss and Chang 1982), whose
/// coefficients follow from one another by the equation itself: each step takes as many of them as leave less
/// than 1e-12 of the motion; with a cubic spring, whose series is no exponential's, it ends where the last
/// two are still small (Jorba and Zou 2005). Number: double, or a Dual for the exact derivatives of what is
/// integrated.
///
/// Friction is exact: the series is cut where the speed passes zero; there the part sticks when the other
/// forces are within the friction, until they no longer are (Filippov's solution). Moments of such events
/// carry derivatives too (implicit function), so that nothing is smoothed.
template <typename Number>
class MotionIntegrator {
public:
    using Coefficients = std::array<Number, motionParameters>;

    MotionIntegrator(const MotionTerms& terms, const Coefficients& coefficients);

    /// Without mass the speed follows from the rest and is not looked at. `strain` is x - q.
    void begin(const Number& x, const Number& v, const Number& strain, double force);
    /// For `duration`, while the force runs straight. False: the motion left all bounds, or is too stiff to
    /// follow for so long.
    [[nodiscard]] bool advance(double duration, double from, double to);

    [[nodiscard]] const Number& position() const { return m_x; }
    [[nodiscard]] const Number& speed() const { return m_v; }
    [[nodiscard]] const Number& strain() const { return m_strain; }
    /// Of the friction: 1, -1, or 0 where the part sticks.
    [[nodiscard]] int way() const { return m_way; }
    /// The largest of the motion's own rates, from above.
    [[nodiscard]] double rate() const;
    /// In how many steps a time is followed that is so many of the motion's fastest own times; 0: too many.
    [[nodiscard]] static int stepsOver(double span);

private:
    static constexpr int mostTerms = 26;
    static constexpr int moreWithCubic = 4;  ///< its terms fall more slowly than an exponential's
    static constexpr double longestStep = 1; ///< over the fastest of the motion's own times
    /// Between two readings: more than a few radians no record determines.
    static constexpr int mostSubsteps = 16, mostEvents = 24, mostPieces = 64;
    using Series = std::array<Number, mostTerms + 1>;

    [[nodiscard]] const Number& of(MotionParameter parameter) const
    {
        return m_c[static_cast<std::size_t>(parameter)];
    }
    [[nodiscard]] double reach(double wanted) const;
    [[nodiscard]] bool segmentWithoutEvents(double duration, Number force, double slope);
    [[nodiscard]] bool segment(double duration, const Number& force, double slope);
    void expand(const Number& force, double slope);
    void expandHeld(const Number& force, double slope);
    void springSeries(int n);
    [[nodiscard]] Number springForce(int n) const;
    [[nodiscard]] Number restForce(const Number& force) const;
    [[nodiscard]] std::optional<double> firstEvent(double duration) const;
    [[nodiscard]] double eventFunction(double t) const;
    struct EventLook {
        double time, function; ///< not below zero at the low end, below it at the high one
    };
    [[nodiscard]] double eventBetween(EventLook low, EventLook high, double within) const;
    template <typename Time>
    void moveTo(const Time& t);
    void decide(const Number& force);
    [[nodiscard]] Number eventTime(double t) const;

    template <typename Time>
    [[nodiscard]] Number at(const Series& series, const Time& t) const;
    [[nodiscard]] double valueAt(const Series& series, double t) const;
    [[nodiscard]] double slopeAt(const Series& series, double t) const;

    MotionTerms m_terms;
    Coefficients m_c;
    Number m_x{}, m_v{}, m_strain{};
    int m_way = 1;
    int m_order = mostTerms;
    Series m_xs, m_vs, m_strains, m_net;           ///< coefficients; of what holds the part while it sticks
    std::array<double, mostTerms + 1> m_squares{}; ///< of x^2, as values: the derivatives do without its own
};

template <typename Number>
MotionIntegrator<Number>::MotionIntegrator(const MotionTerms& terms, const Coefficients& coefficients)
    : m_terms(terms), m_c(coefficients)
{
}

template <typename Number>
void MotionIntegrator<Number>::begin(const Number& x, const Number& v, const Number& strain, double force)
{
    m_x = x;
    m_v = m_terms.mass ? v : Number(0);
    m_strain = strain;
    if (!m_terms.friction && !m_terms.eachWay)
        return;
    if (valuePart(m_v) == 0)
        decide(Number(force));
    else
        m_way = valuePart(m_v) > 0 ? 1 : -1;
}

template <typename Number>
double MotionIntegrator<Number>::rate() const
{
    using P = MotionParameter;
    double stiffness = m_terms.spring ? valuePart(of(P::Stiffness)) : 0;
    double damping = valuePart(of(P::Damping));
    if (m_terms.eachWay)
        damping = std::max(damping, valuePart(of(P::DampingBack)));
    double own = 0;
    if (m_terms.relaxation) {
        stiffness += valuePart(of(P::Relaxing));
        own = 1 / valuePart(of(P::RelaxationTime));
    }
    if (m_terms.cubic)
        stiffness += 3 * std::abs(valuePart(of(P::Cubic))) * valuePart(m_x) * valuePart(m_x);
    if (!m_terms.mass)
        return own + stiffness / damping;
    const double mass = valuePart(of(P::Mass));
    return std::max(own, damping / mass) + std::sqrt(stiffness / mass);
}

template <typename Number>
int MotionIntegrator<Number>::stepsOver(double span)
{
    if (!(span <= longestStep * mostSubsteps))
        return 0;
    return std::max(1, static_cast<int>(std::ceil(span / longestStep)));
}

template <typename Number>
bool MotionIntegrator<Number>::advance(double duration, double from, double to)
{
    const double span = rate() * duration;
    const int steps = stepsOver(span);
    if (steps == 0)
        return false;
    const double step = duration / steps;
    // The remainder of an exponential's series.
    constexpr double smallest = 1e-13;
    const double scaled = span / steps;
    double term = scaled * scaled / 2;
    m_order = 2;
    while (m_order < mostTerms && term > smallest)
        term *= scaled / ++m_order;
    if (m_terms.cubic)
        m_order = std::min(m_order + moreWithCubic, mostTerms);
    const double slope = (to - from) / duration;
    for (int i = 0; i < steps; ++i)
        if (!segment(step, Number(from + slope * (i * step)), slope))
            return false;
    return std::isfinite(valuePart(m_x)) && std::isfinite(valuePart(m_v));
}

/// How far of `wanted` the series goes, as it was expanded: until one of its last two terms is more than
/// rounding beside the motion. Without a cubic spring that has been seen to already.
template <typename Number>
double MotionIntegrator<Number>::reach(double wanted) const
{
    constexpr double smallest = 1e-14;
    if (!m_terms.cubic || (m_terms.friction && m_way == 0))
        return wanted;
    const double own = rate();
    const double size = std::abs(valuePart(m_xs[0])) + std::abs(valuePart(m_xs[1])) / own +
                        std::abs(valuePart(m_xs[2])) / (own * own);
    double power = 1; // of `wanted`: mostly it is all within reach, and a root costs more than the series
    for (int n = 1; n < m_order; ++n)
        power *= wanted;
    double shortest = wanted;
    for (const int n : {m_order - 1, m_order}) {
        const double last = std::abs(valuePart(m_xs[static_cast<std::size_t>(n)]));
        if (last * power > smallest * size)
            shortest = std::min(shortest, std::pow(smallest * size / last, 1.0 / n));
        power *= wanted;
    }
    return shortest;
}

template <typename Number>
bool MotionIntegrator<Number>::segmentWithoutEvents(double duration, Number force, double slope)
{
    for (int i = 0; i < mostPieces; ++i) {
        expand(force, slope);
        const double step = reach(duration);
        moveTo(step);
        duration -= step;
        if (!(duration > 0))
            return true;
        force += slope * step;
    }
    return false;
}

template <typename Number>
bool MotionIntegrator<Number>::segment(double duration, const Number& force, double slope)
{
    if (!m_terms.friction && !m_terms.eachWay)
        return segmentWithoutEvents(duration, force, slope);
    if (valuePart(m_v) == 0)
        decide(force); // the force may have jumped
    Number left(duration);
    Number now = force;
    int events = 0;
    for (int i = 0; i < mostPieces && events < mostEvents; ++i) {
        if (m_way == 0)
            expandHeld(now, slope);
        else
            expand(now, slope);
        const double step = reach(valuePart(left));
        const bool last = valuePart(left) <= step;
        const std::optional<double> event = firstEvent(last ? valuePart(left) : step);
        if (!event && last) {
            moveTo(left);
            return true;
        }
        const Number t = event ? eventTime(*event) : Number(step);
        moveTo(t);
        now += slope * t;
        left -= t;
        if (!event)
            continue;
        ++events;
        if (m_way == 0) {
            m_way = valuePart(restForce(now)) > 0 ? 1 : -1;
        } else {
            m_v = Number(0);
            decide(now);
        }
    }
    if (events < mostEvents)
        return false;
    m_way = 0; // it chatters: less than the arithmetic can tell from rest
    m_v = Number(0);
    expandHeld(now, slope);
    moveTo(left);
    return true;
}

/// k x + k3 x^3 + k1 (x - q), the n-th coefficient.
template <typename Number>
Number MotionIntegrator<Number>::springForce(int n) const
{
    using P = MotionParameter;
    const auto i = static_cast<std::size_t>(n);
    Number sum(0);
    if (m_terms.spring)
        sum += of(P::Stiffness) * m_xs[i];
    if (m_terms.relaxation)
        sum += of(P::Relaxing) * m_strains[i];
    if (m_terms.cubic) {
        Number cube(0); // d(x^3) = 3 x^2 dx
        for (std::size_t j = 0; j <= i; ++j)
            cube += m_squares[j] * m_xs[i - j];
        sum += of(P::Cubic) * withSlopesTimes(3, cube);
    }
    return sum;
}

template <typename Number>
void MotionIntegrator<Number>::springSeries(int n)
{
    if (!m_terms.cubic)
        return;
    const auto i = static_cast<std::size_t>(n);
    double half = 0; // each product comes twice, but for one in the middle
    for (std::size_t j = 0; 2 * j < i; ++j)
        half += valuePart(m_xs[j]) * valuePart(m_xs[i - j]);
    m_squares[i] = half * 2;
    if (i % 2 == 0)
        m_squares[i] += valuePart(m_xs[i / 2]) * valuePart(m_xs[i / 2]);
}

template <typename Number>
void MotionIntegrator<Number>::expand(const Number& force, double slope)
{
    using P = MotionParameter;
    const bool back = m_terms.eachWay && m_way < 0;
    const Number& damping = of(back ? P::DampingBack : P::Damping);
    Number constant = force;
    if (m_terms.friction)
        constant -= static_cast<double>(m_way) * of(back ? P::FrictionBack : P::Friction);
    if (m_terms.forceOffset)
        constant += of(P::ForceOffset);
    const Number inertia = Number(1) / (m_terms.mass ? of(P::Mass) : damping);
    const Number rate = m_terms.relaxation ? Number(1) / of(P::RelaxationTime) : Number(0);
    m_xs[0] = m_x;
    m_vs[0] = m_v;
    m_strains[0] = m_strain;
    for (int n = 0; n < m_order; ++n) {
        const auto i = static_cast<std::size_t>(n);
        springSeries(n);
        Number net = n == 0 ? constant : n == 1 ? Number(slope) : Number(0);
        net -= springForce(n);
        if (m_terms.mass) {
            net -= damping * m_vs[i];
            m_vs[i + 1] = net * inertia * (1.0 / (n + 1));
        } else {
            m_vs[i] = net * inertia;
        }
        m_xs[i + 1] = m_vs[i] * (1.0 / (n + 1));
        if (m_terms.relaxation)
            m_strains[i + 1] = (m_vs[i] - m_strains[i] * rate) * (1.0 / (n + 1));
    }
    if (!m_terms.mass)
        m_vs[static_cast<std::size_t>(m_order)] = Number(0);
}

/// While the part sticks its dashpot goes on relaxing; m_net is what the friction has to hold.
template <typename Number>
void MotionIntegrator<Number>::expandHeld(const Number& force, double slope)
{
    using P = MotionParameter;
    const Number rate = m_terms.relaxation ? Number(1) / of(P::RelaxationTime) : Number(0);
    m_xs[0] = m_x;
    m_strains[0] = m_strain;
    m_net[0] = restForce(force);
    for (int n = 0; n < m_order; ++n) {
        const auto i = static_cast<std::size_t>(n);
        m_xs[i + 1] = Number(0);
        m_vs[i] = Number(0);
        m_net[i + 1] = n == 0 ? Number(slope) : Number(0);
        if (!m_terms.relaxation)
            continue;
        m_strains[i + 1] = m_strains[i] * rate * (-1.0 / (n + 1));
        m_net[i + 1] -= of(P::Relaxing) * m_strains[i + 1];
    }
    m_vs[static_cast<std::size_t>(m_order)] = Number(0);
}

/// The force on a part at rest, but for friction.
template <typename Number>
Number MotionIntegrator<Number>::restForce(const Number& force) const
{
    using P = MotionParameter;
    Number net = force;
    if (m_terms.forceOffset)
        net += of(P::ForceOffset);
    if (m_terms.spring)
        net -= of(P::Stiffness) * m_x;
    if (m_terms.relaxation)
        net -= of(P::Relaxing) * m_strain;
    if (m_terms.cubic)
        net -= of(P::Cubic) * (m_x * m_x * m_x);
    return net;
}

template <typename Number>
void MotionIntegrator<Number>::decide(const Number& force)
{
    using P = MotionParameter;
    const double net = valuePart(restForce(force));
    const double forth = m_terms.friction ? valuePart(of(P::Friction)) : 0;
    const double back = m_terms.friction && m_terms.eachWay ? valuePart(of(P::FrictionBack)) : forth;
    m_way = net > forth ? 1 : net < -back ? -1 : m_terms.friction ? 0 : 1;
}

template <typename Number>
double MotionIntegrator<Number>::eventFunction(double t) const
{
    using P = MotionParameter;
    if (m_way != 0)
        return m_way * valueAt(m_vs, t);
    const double net = valueAt(m_net, t);
    const double forth = valuePart(of(P::Friction));
    const double back = m_terms.eachWay ? valuePart(of(P::FrictionBack)) : forth;
    return std::min(forth - net, net + back);
}

/// The first moment within the step at which the speed passes zero, or the friction holds no longer.
template <typename Number>
std::optional<double> MotionIntegrator<Number>::firstEvent(double duration) const
{
    constexpr int looks = 4;
    constexpr double soonest = 1e-9;
    EventLook low{0, eventFunction(0)};
    const bool begins = m_way != 0 && !(low.function > 0);
    for (int i = 1; i <= looks; ++i) {
        const double after = duration * i / looks;
        const EventLook high{after, eventFunction(after)};
        if (high.function < 0) {
            // From rest: it has to move before it turns, if ever so little.
            if (begins && i == 1)
                for (double soon = after / 16; !(low.function > 0); soon /= 64) {
                    if (soon < soonest * duration)
                        return std::nullopt;
                    low = {soon, eventFunction(soon)};
                }
            return eventBetween(low, high, 1e-15 * duration);
        }
        low = high;
    }
    return std::nullopt;
}

/// By the false position, the end that stays twice counted half (Dowell and Jarratt 1971).
template <typename Number>
double MotionIntegrator<Number>::eventBetween(EventLook low, EventLook high, double within) const
{
    constexpr int mostSteps = 60;
    int kept = 0; // 1: the low end, -1: the high one
    for (int n = 0; n < mostSteps && high.time - low.time > within; ++n) {
        const double share = std::max(low.function, 0.0) / (std::max(low.function, 0.0) - high.function);
        const double at = low.time + (high.time - low.time) * share;
        if (!(at > low.time && at < high.time))
            break;
        const double function = eventFunction(at);
        if (function == 0)
            return at;
        if (function > 0) {
            low = {at, function};
            high.function *= kept == -1 ? 0.5 : 1;
            kept = -1;
        } else {
            high = {at, function};
            low.function *= kept == 1 ? 0.5 : 1;
            kept = 1;
        }
    }
    return std::abs(low.function) < std::abs(high.function) ? low.time : high.time;
}

template <typename Number>
Number MotionIntegrator<Number>::eventTime(double t) const
{
    // One step of Newton's method adds the derivatives and takes none of the value away.
    const Series& series = m_way != 0 ? m_vs : m_net;
    const double slope = slopeAt(series, t);
    if (slope == 0)
        return Number(t);
    Number function = at(series, t);
    if (m_way == 0) {
        using P = MotionParameter;
        const bool forth = valuePart(function) > 0;
        if (forth)
            function -= of(P::Friction);
        else
            function += of(m_terms.eachWay ? P::FrictionBack : P::Friction);
    }
    Number time = function * (-1 / slope);
    time += Number(t - valuePart(time));
    return time;
}

template <typename Number>
template <typename Time>
void MotionIntegrator<Number>::moveTo(const Time& t)
{
    m_x = at(m_xs, t);
    m_v = at(m_vs, t);
    if (m_terms.relaxation)
        m_strain = at(m_strains, t);
}

template <typename Number>
template <typename Time>
Number MotionIntegrator<Number>::at(const Series& series, const Time& t) const
{
    Number sum = series[static_cast<std::size_t>(m_order)];
    for (int n = m_order; n-- > 0;)
        sum = sum * t + series[static_cast<std::size_t>(n)];
    return sum;
}

template <typename Number>
double MotionIntegrator<Number>::valueAt(const Series& series, double t) const
{
    double sum = 0;
    for (int n = m_order; n >= 0; --n)
        sum = sum * t + valuePart(series[static_cast<std::size_t>(n)]);
    return sum;
}

template <typename Number>
double MotionIntegrator<Number>::slopeAt(const Series& series, double t) const
{
    double sum = 0;
    for (int n = m_order; n >= 1; --n)
        sum = sum * t + n * valuePart(series[static_cast<std::size_t>(n)]);
    return sum;
}

} // namespace gripscope
