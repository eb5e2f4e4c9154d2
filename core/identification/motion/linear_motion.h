// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/motion_integrator.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace gripscope {

/// What MotionIntegrator does where no term bends the motion: then the state s = (x, v, x - q) after a time T
/// is
///     s(T) = s_free + A s(0) + B F(0) + C F',
/// the force running straight. The integrator is asked once for the answers to each part, derivatives
/// included; a sample then costs a few products instead of a series.
template <typename Number>
class LinearMotion {
public:
    [[nodiscard]] static bool describes(const MotionTerms& terms)
    {
        return !terms.friction && !terms.eachWay && !terms.cubic;
    }

    LinearMotion(const MotionTerms& terms,
                 const typename MotionIntegrator<Number>::Coefficients& coefficients)
        : m_terms(terms), m_coefficients(coefficients)
    {
    }

    void begin(const Number& x, const Number& v, const Number& strain) { m_state = {x, v, strain}; }
    /// As MotionIntegrator::advance.
    [[nodiscard]] bool advance(double duration, double from, double to)
    {
        const Answers* const answers = answersFor(duration);
        if (answers == nullptr)
            return false;
        const double slope = to == from ? 0 : (to - from) / duration;
        if (m_terms.relaxation)
            move<3>(*answers, from, slope);
        else
            move<2>(*answers, from, slope);
        return std::isfinite(valuePart(m_state[0])) && std::isfinite(valuePart(m_state[1]));
    }

    [[nodiscard]] const Number& position() const { return m_state[0]; }
    [[nodiscard]] const Number& speed() const { return m_state[1]; }
    [[nodiscard]] const Number& strain() const { return m_state[2]; }

private:
    static constexpr std::size_t states = 3;
    using State = std::array<Number, states>;

    struct Answers {
        double duration = 0;
        bool bounded = true;
        State free, toForce, toSlope;
        std::array<State, states> toState;
    };

    /// The first so many of the states: without a dashpot there is no strain. (Without a mass the answers to
    /// a speed are zero.)
    template <std::size_t Count>
    void move(const Answers& answers, double from, double slope)
    {
        State next = answers.free;
        for (std::size_t i = 0; i < Count; ++i) {
            for (std::size_t j = 0; j < Count; ++j)
                addProduct(next[i], answers.toState[j][i], m_state[j]);
            addProduct(next[i], answers.toForce[i], from);
            if (slope != 0)
                addProduct(next[i], answers.toSlope[i], slope);
        }
        m_state = next;
    }

    /// A record has two durations at most: before and after the position's time.
    const Answers* answersFor(double duration)
    {
        for (const Answers& known : m_answers)
            if (known.duration == duration)
                return known.bounded ? &known : nullptr;
        Answers found;
        found.duration = duration;
        found.free = answer(found, {}, 0, 0);
        found.toForce = less(answer(found, {}, 1, 1), found.free);
        found.toSlope = less(answer(found, {}, 0, duration), found.free);
        for (std::size_t j = 0; j < states; ++j) {
            State unit{};
            unit[j] = Number(1);
            found.toState[j] = less(answer(found, unit, 0, 0), found.free);
        }
        m_answers.push_back(found);
        return found.bounded ? &m_answers.back() : nullptr;
    }
    State answer(Answers& found, const State& start, double from, double to) const
    {
        MotionIntegrator<Number> integrator(m_terms, m_coefficients);
        integrator.begin(start[0], start[1], start[2], from);
        found.bounded = integrator.advance(found.duration, from, to) && found.bounded;
        return {integrator.position(), integrator.speed(), integrator.strain()};
    }
    static State less(State a, const State& b)
    {
        for (std::size_t i = 0; i < states; ++i)
            a[i] -= b[i];
        return a;
    }

    MotionTerms m_terms;
    typename MotionIntegrator<Number>::Coefficients m_coefficients;
    State m_state;
    std::vector<Answers> m_answers;
};

} // namespace gripscope
