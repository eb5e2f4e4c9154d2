// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/real_part.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

struct State {
    double x = 0, v = 0, q = 0, z = 0;

    friend State operator+(const State& a, const State& b)
    {
        return {a.x + b.x, a.v + b.v, a.q + b.q, a.z + b.z};
    }
    friend State operator*(double f, const State& a) { return {f * a.x, f * a.v, f * a.q, f * a.z}; }
};

class Simulator {
public:
    explicit Simulator(const RealPart& part) : m_part(part) {}

    /// In equilibrium, approached from below: friction holds nothing.
    void begin(double force)
    {
        double x = force / m_part.k;
        for (int i = 0; i < 50 && m_part.cubic != 0; ++i)
            x -= (m_part.k * x + m_part.cubic * x * x * x - force) / (m_part.k + 3 * m_part.cubic * x * x);
        m_state = {x, 0, x, 0};
    }
    /// The force runs straight from `from` to `to`.
    void advance(double duration, double from, double to, double longest)
    {
        const auto steps = std::max(1, static_cast<int>(std::ceil(duration / longest)));
        for (int i = 0; i < steps; ++i) {
            const double a = from + (to - from) * i / steps;
            const double b = from + (to - from) * (i + 1) / steps;
            step(duration / steps, a, b);
        }
    }
    [[nodiscard]] double position() const { return m_state.x; }

private:
    /// All forces on the mass but those of friction and of the damper.
    [[nodiscard]] double net(const State& s, double force) const
    {
        return force - m_part.k * s.x - m_part.cubic * s.x * s.x * s.x - m_part.relaxing * (s.x - s.q) -
               m_part.hysteresis * s.z;
    }
    [[nodiscard]] State rates(const State& s, double force, int way) const
    {
        State d;
        d.x = s.v;
        d.v = (net(s, force) - m_part.b * s.v - way * m_part.friction) / m_part.m;
        d.q = m_part.relaxing > 0 ? (s.x - s.q) / m_part.relaxationTime_s : 0;
        d.z = m_part.hysteresis > 0 ? (s.v - std::abs(s.v) * s.z) / m_part.hysteresisReach : 0;
        return d;
    }
    [[nodiscard]] State moved(const State& s, double h, double from, double to, int way) const
    {
        const double middle = (from + to) / 2;
        const State a = rates(s, from, way);
        const State b = rates(s + h / 2 * a, middle, way);
        const State c = rates(s + h / 2 * b, middle, way);
        const State d = rates(s + h * c, to, way);
        return s + h / 6 * (a + 2 * b + 2 * c + d);
    }
    void relax(double h)
    {
        if (m_part.relaxing > 0)
            m_state.q = m_state.x + (m_state.q - m_state.x) * std::exp(-h / m_part.relaxationTime_s);
    }
    void step(double h, double from, double to)
    {
        if (m_part.friction <= 0) {
            m_state = moved(m_state, h, from, to, 0);
            return;
        }
        constexpr int mostTurns = 4;
        for (int turn = 0; turn < mostTurns && h > 0; ++turn) {
            if (m_state.v == 0 && std::abs(net(m_state, from)) <= m_part.friction) {
                rest(h, from, to);
                if (h <= 0)
                    return;
            }
            const double pull = net(m_state, from);
            const int way = m_state.v > 0 || (m_state.v == 0 && pull > 0) ? 1 : -1;
            const State next = moved(m_state, h, from, to, way);
            if (next.v * way >= 0) {
                m_state = next;
                return;
            }
            // It turns within the step: up to there, and on from rest.
            double low = 0;
            double high = 1;
            for (int i = 0; i < 50; ++i) {
                const double share = (low + high) / 2;
                const double then = from + (to - from) * share;
                (moved(m_state, share * h, from, then, way).v * way >= 0 ? low : high) = share;
            }
            const double then = from + (to - from) * low;
            m_state = moved(m_state, low * h, from, then, way);
            m_state.v = 0;
            from = then;
            h *= 1 - low;
        }
    }
    /// Sticks for as long as it does; the rest of the step is left in h and from.
    void rest(double& h, double& from, double to)
    {
        const double before = m_state.q;
        relax(h);
        if (std::abs(net(m_state, to)) <= m_part.friction) {
            h = 0;
            return;
        }
        double low = 0;
        double high = 1;
        for (int i = 0; i < 50; ++i) {
            const double share = (low + high) / 2;
            m_state.q = before;
            relax(share * h);
            const bool holds = std::abs(net(m_state, from + (to - from) * share)) <= m_part.friction;
            (holds ? low : high) = share;
        }
        m_state.q = before;
        relax(high * h);
        from += (to - from) * high;
        h *= 1 - high;
    }

    const RealPart m_part;
    State m_state;
};

} // namespace

std::vector<double> simulateRealPart(const RealPart& part, const std::vector<double>& forceTimes_s,
                                     const std::vector<double>& force, ForceHold hold,
                                     const std::vector<double>& times_s, double step_s)
{
    std::vector<double> positions;
    if (force.empty() || force.size() != forceTimes_s.size())
        return positions;
    positions.reserve(times_s.size());
    Simulator simulator(part);
    simulator.begin(force.front());
    double now = forceTimes_s.front();
    std::size_t at = 0; // the force's interval that `now` is in
    const auto forceAt = [&](double time) {
        if (hold == ForceHold::Zero || at + 1 >= force.size())
            return force[at];
        const double share = (time - forceTimes_s[at]) / (forceTimes_s[at + 1] - forceTimes_s[at]);
        return force[at] + (force[at + 1] - force[at]) * share;
    };
    for (const double time : times_s) {
        while (now < time) {
            while (at + 1 < force.size() && forceTimes_s[at + 1] <= now)
                ++at;
            const double end = at + 1 < force.size() ? std::min(time, forceTimes_s[at + 1]) : time;
            simulator.advance(end - now, forceAt(now), forceAt(end), step_s);
            now = end;
        }
        positions.push_back(simulator.position());
    }
    return positions;
}

} // namespace gripscope
