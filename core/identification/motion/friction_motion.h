// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/cubic_motion.h"
#include "core/identification/motion/linear_motion.h"
#include "core/identification/motion/motion_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

/// What MotionIntegrator does with friction, or a damping of its own each way: between two moments at which
/// the speed passes zero the motion is `Smooth`, that of LinearMotion or CubicMotion with an offset of the
/// force. The integrator is asked for the samples in which such a moment is, or may be.
template <typename Number, typename Smooth = LinearMotion<Number>>
class FrictionMotion {
public:
    using Coefficients = typename MotionIntegrator<Number>::Coefficients;

    [[nodiscard]] static bool describes(const MotionTerms& terms)
    {
        return terms.mass && (terms.friction || terms.eachWay) && Smooth::describes(smoothTerms(terms));
    }

    FrictionMotion(const MotionTerms& terms, const Coefficients& coefficients)
        : m_terms(terms), m_c(coefficients), m_exact(terms, coefficients), m_rate(m_exact.rate()),
          m_forth(smoothTerms(terms), smoothCoefficients(terms, coefficients, 1)),
          m_back(smoothTerms(terms), smoothCoefficients(terms, coefficients, -1))
    {
    }

    void begin(const Number& x, const Number& v, const Number& strain)
    {
        m_x = x;
        m_v = v;
        m_strain = strain;
    }
    /// As MotionIntegrator::advance.
    [[nodiscard]] bool advance(double duration, double from, double to)
    {
        const int steps = MotionIntegrator<Number>::stepsOver(m_rate * duration);
        const double slope = to == from ? 0 : (to - from) / duration;
        const double step = steps == 1 ? duration : duration / steps;
        for (int i = 0; i < steps; ++i)
            if (!advanceStep(step, from + slope * (i * step), from + slope * ((i + 1) * step)))
                return false;
        return steps > 0 && std::isfinite(valuePart(m_x)) && std::isfinite(valuePart(m_v));
    }

    [[nodiscard]] const Number& position() const { return m_x; }

private:
    using P = MotionParameter;

    static MotionTerms smoothTerms(MotionTerms terms)
    {
        terms.friction = terms.eachWay = false;
        terms.forceOffset = true;
        return terms;
    }
    /// Of motion that way: friction is an offset of the force.
    static Coefficients smoothCoefficients(const MotionTerms& terms, Coefficients c, int way)
    {
        const auto of = [&c](P parameter) -> Number& { return c[static_cast<std::size_t>(parameter)]; };
        const bool back = terms.eachWay && way < 0;
        if (!terms.forceOffset)
            of(P::ForceOffset) = Number(0);
        if (terms.friction)
            of(P::ForceOffset) -= static_cast<double>(way) * of(back ? P::FrictionBack : P::Friction);
        if (back)
            of(P::Damping) = of(P::DampingBack);
        return c;
    }

    [[nodiscard]] double valueOf(P parameter) const
    {
        return valuePart(m_c[static_cast<std::size_t>(parameter)]);
    }
    [[nodiscard]] double frictionOf(int way) const
    {
        return !m_terms.friction ? 0 : valueOf(m_terms.eachWay && way < 0 ? P::FrictionBack : P::Friction);
    }
    /// All but damping and friction.
    [[nodiscard]] double restForce(double force, double x, double strain) const
    {
        return force + (m_terms.forceOffset ? valueOf(P::ForceOffset) : 0) -
               (m_terms.spring ? valueOf(P::Stiffness) * x : 0) -
               (m_terms.cubic ? valueOf(P::Cubic) * x * x * x : 0) -
               (m_terms.relaxation ? valueOf(P::Relaxing) * strain : 0);
    }

    [[nodiscard]] int wayAt(double force)
    {
        if (valuePart(m_v) != 0)
            return valuePart(m_v) > 0 ? 1 : -1;
        m_exact.begin(m_x, m_v, m_strain, force);
        return m_exact.way();
    }

    [[nodiscard]] bool advanceStep(double duration, double from, double to)
    {
        const int way = wayAt(from);
        if (way == 0)
            return staysAtRest(duration, from, to) || advanceExactly(duration, from, to);
        Smooth& smooth = way > 0 ? m_forth : m_back;
        smooth.begin(m_x, m_v, m_strain);
        if (!smooth.advance(duration, from, to))
            return false;
        if (!keepsItsWay(way, duration, from, to, smooth))
            return advanceExactly(duration, from, to);
        begin(smooth.position(), smooth.speed(), smooth.strain());
        return true;
    }

    [[nodiscard]] bool advanceExactly(double duration, double from, double to)
    {
        m_exact.begin(m_x, m_v, m_strain, from);
        if (!m_exact.advance(duration, from, to))
            return false;
        begin(m_exact.position(), m_exact.speed(), m_exact.strain());
        return true;
    }

    /// Friction holds the part for all of the time: the force and the dashpot each go one way only.
    [[nodiscard]] bool staysAtRest(double duration, double from, double to)
    {
        const Number kept = keptStrain(duration);
        const double before = valuePart(m_strain);
        const double after = before * valuePart(kept);
        const double x = valuePart(m_x);
        if (restForce(std::max(from, to), x, std::min(before, after)) > frictionOf(1) ||
            restForce(std::min(from, to), x, std::max(before, after)) < -frictionOf(-1))
            return false;
        m_v = Number(0);
        m_strain = m_strain * kept;
        return true;
    }
    /// exp(-t / tau)
    [[nodiscard]] Number keptStrain(double duration) const
    {
        if (!m_terms.relaxation)
            return Number(1);
        const Number& tau = m_c[static_cast<std::size_t>(P::RelaxationTime)];
        const double t = valuePart(tau);
        const double kept = std::exp(-duration / t);
        return Number(kept) + (tau - Number(t)) * (kept * duration / (t * t));
    }

    /// The speed does not come to zero within the step, whose acceleration turns at most once: it is no lower
    /// than where its tangents at both ends meet.
    [[nodiscard]] bool keepsItsWay(int way, double duration, double from, double to, const Smooth& next) const
    {
        const double before = way * valuePart(m_v);
        const double after = way * valuePart(next.speed());
        if (!(after > 0))
            return false;
        const double first = acceleration(way, from, m_x, m_v, m_strain);
        if (before == 0 && !(first > 0))
            return false;
        if (first >= 0)
            return true;
        const double last = acceleration(way, to, next.position(), next.speed(), next.strain());
        if (last <= 0)
            return true;
        const double meeting = (after - before - last * duration) / (first - last);
        return before + first * meeting > 0;
    }
    /// Along the way.
    [[nodiscard]] double acceleration(int way, double force, const Number& x, const Number& v,
                                      const Number& strain) const
    {
        const P damping = m_terms.eachWay && way < 0 ? P::DampingBack : P::Damping;
        const double net = restForce(force, valuePart(x), valuePart(strain)) -
                           valueOf(damping) * valuePart(v) - way * frictionOf(way);
        return way * net / valueOf(P::Mass);
    }

    const MotionTerms m_terms;
    const Coefficients m_c;
    MotionIntegrator<Number> m_exact;
    const double m_rate;
    Smooth m_forth, m_back;
    Number m_x{}, m_v{}, m_strain{};
};

} // namespace gripscope
