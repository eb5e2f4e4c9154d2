// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/force_projection.h"

#include <algorithm>

namespace gripscope {

namespace {

/// The samples' held function, read at times that do not decrease.
class HeldForce {
public:
    HeldForce(std::span<const double> force, std::span<const double> time, ForceHold hold)
        : m_force(force), m_time(time), m_hold(hold)
    {
    }
    /// Goes to the segment that holds `at`, the last one that begins there or before.
    void moveTo(double at)
    {
        while (m_segment + 1 < m_time.size() && m_time[m_segment + 1] <= at)
            ++m_segment;
    }
    /// The end of the segment, or `atMost`.
    [[nodiscard]] double segmentEnd(double atMost) const
    {
        return m_segment + 1 < m_time.size() ? std::min(m_time[m_segment + 1], atMost) : atMost;
    }
    /// The value on the segment, continued beyond its ends.
    [[nodiscard]] double value(double at) const
    {
        if (m_hold == ForceHold::Zero || m_time.size() < 2)
            return m_force[m_segment];
        const std::size_t i = std::min(m_segment, m_time.size() - 2);
        const double share = (at - m_time[i]) / (m_time[i + 1] - m_time[i]);
        return (1 - share) * m_force[i] + share * m_force[i + 1];
    }

private:
    std::span<const double> m_force, m_time;
    ForceHold m_hold;
    std::size_t m_segment = 0;
};

/// Integrals of the force over one sample time, times the falling and the rising half of a hat.
struct Moments {
    double falling = 0, rising = 0;
};

Moments momentsOver(HeldForce& force, double start)
{
    Moments moments;
    for (double at = start; at < start + 1;) {
        force.moveTo(at);
        const double end = force.segmentEnd(start + 1);
        const double first = force.value(at), last = force.value(end), length = end - at;
        const double u = at - start, v = end - start;
        // Exact for products of two straight lines (Simpson).
        moments.rising += length / 6 * (first * u + (first + last) * (u + v) + last * v);
        moments.falling += length / 6 * (first * (1 - u) + (first + last) * (2 - u - v) + last * (1 - v));
        at = end;
    }
    return moments;
}

/// Solves the tridiagonal system of the hat functions (Thomas); diagonally dominant, so no pivots.
std::vector<double> solveHats(std::vector<double> right)
{
    const std::size_t count = right.size();
    const auto diagonal = [count](std::size_t n) { return n == 0 || n + 1 == count ? 1.0 / 3 : 2.0 / 3; };
    std::vector<double> pivots(count, diagonal(0));
    for (std::size_t n = 1; n < count; ++n) {
        const double factor = 1 / (6 * pivots[n - 1]);
        pivots[n] = diagonal(n) - factor / 6;
        right[n] -= factor * right[n - 1];
    }
    right[count - 1] /= pivots[count - 1];
    for (std::size_t n = count - 1; n-- > 0;)
        right[n] = (right[n] - right[n + 1] / 6) / pivots[n];
    return right;
}

} // namespace

std::vector<double> projectForce(std::span<const double> force, std::span<const double> time,
                                 std::int64_t firstPoint, std::size_t count, ForceHold hold)
{
    std::vector<double> values(count, 0.0);
    if (count == 0 || force.empty() || force.size() != time.size())
        return values;
    HeldForce held(force, time, hold);
    if (hold == ForceHold::First && count == 1) {
        held.moveTo(static_cast<double>(firstPoint));
        return {held.value(static_cast<double>(firstPoint))};
    }
    const std::size_t intervals = hold == ForceHold::Zero ? count : count - 1;
    for (std::size_t n = 0; n < intervals; ++n) {
        const Moments moments = momentsOver(held, static_cast<double>(firstPoint) + static_cast<double>(n));
        if (hold == ForceHold::Zero) {
            values[n] = moments.falling + moments.rising;
            continue;
        }
        values[n] += moments.falling;
        values[n + 1] += moments.rising;
    }
    return hold == ForceHold::Zero ? values : solveHats(std::move(values));
}

} // namespace gripscope
