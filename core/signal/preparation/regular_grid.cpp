// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/preparation_parts.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double outsideStretch = 0.3; ///< sample times that a grid point may lie outside
constexpr double widestStencil = 5;    ///< sample times that four samples may span

/// The polynomial through the points (time, value), at `at` (Lagrange).
double interpolate(std::span<const double> time, std::span<const double> value, double at)
{
    double sum = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        double weight = 1;
        for (std::size_t j = 0; j < time.size(); ++j)
            weight *= j == i ? 1 : (at - time[j]) / (time[i] - time[j]);
        sum += weight * value[i];
    }
    return sum;
}

/// A stretch without loss: samples [first, end), grid points [firstPoint, endPoint).
struct Stretch {
    std::size_t first = 0, end = 0;
    std::int64_t firstPoint = 0, endPoint = 0;
};

std::vector<Stretch> findStretches(std::span<const std::int64_t> index, std::span<const double> time,
                                   std::int64_t points)
{
    std::vector<Stretch> stretches;
    std::int64_t nextPoint = 0;
    for (std::size_t i = 0; i < index.size();) {
        Stretch stretch;
        stretch.first = i++;
        while (i < index.size() && index[i] == index[i - 1] + 1)
            ++i;
        stretch.end = i;
        const auto origin = static_cast<double>(index.front());
        const double from = std::ceil(time[stretch.first] - origin - outsideStretch);
        const double to = std::floor(time[stretch.end - 1] - origin + outsideStretch) + 1;
        stretch.firstPoint = std::clamp(static_cast<std::int64_t>(from), nextPoint, points);
        stretch.endPoint = std::clamp(static_cast<std::int64_t>(to), stretch.firstPoint, points);
        nextPoint = stretch.endPoint;
        stretches.push_back(stretch);
    }
    return stretches;
}

/// The position at a grid point near the samples of `stretch`, from the four samples around, over single lost
/// samples too; where those are too far apart, from the stretch alone.
double positionAt(std::span<const double> position, std::span<const double> time, const Stretch& stretch,
                  double at)
{
    const auto begin = time.begin() + static_cast<std::ptrdiff_t>(stretch.first);
    const auto end = time.begin() + static_cast<std::ptrdiff_t>(stretch.end);
    const auto after = static_cast<std::size_t>(std::upper_bound(begin, end, at) - time.begin());
    constexpr std::size_t wanted = 4;
    const auto around = [after](std::size_t first, std::size_t last, std::size_t count) {
        const std::size_t left = after >= first + 2 ? after - 2 : first;
        return std::min(left, last - count);
    };
    std::size_t count = std::min(wanted, time.size());
    std::size_t from = around(0, time.size(), count);
    if (time[from + count - 1] - time[from] > widestStencil) {
        count = std::min(wanted, stretch.end - stretch.first);
        from = around(stretch.first, stretch.end, count);
    }
    return interpolate(time.subspan(from, count), position.subspan(from, count), at);
}

void bridge(std::vector<double>& values, std::size_t first, std::size_t end)
{
    const double left = first > 0 ? values[first - 1] : end < values.size() ? values[end] : 0;
    const double right = end < values.size() ? values[end] : left;
    const auto length = static_cast<double>(end - first + 1);
    for (std::size_t n = first; n < end; ++n) {
        const double share = static_cast<double>(n - first + 1) / length;
        values[n] = (1 - share) * left + share * right;
    }
}

/// Fills `lost` and the values there.
void finish(GriddedChannels& grid, const std::vector<bool>& measured)
{
    for (std::size_t n = 0; n < measured.size();) {
        if (measured[n]) {
            ++n;
            continue;
        }
        const std::size_t first = n;
        for (; n < measured.size() && !measured[n]; ++n)
            grid.lost.push_back(n);
        bridge(grid.force, first, n);
        bridge(grid.position, first, n);
    }
}

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

GriddedChannels placeOnGrid(std::span<const double> force, std::span<const double> position,
                            std::span<const std::int64_t> index)
{
    GriddedChannels grid;
    if (index.empty())
        return grid;
    const auto points = static_cast<std::size_t>(index.back() - index.front() + 1);
    grid.force.assign(points, 0.0);
    grid.position.assign(points, 0.0);
    std::vector<bool> measured(points, false);
    for (std::size_t i = 0; i < index.size(); ++i) {
        const auto n = static_cast<std::size_t>(index[i] - index.front());
        grid.force[n] = force[i];
        grid.position[n] = position[i];
        measured[n] = true;
    }
    finish(grid, measured);
    return grid;
}

GriddedChannels resampleToGrid(std::span<const double> force, std::span<const double> position,
                               std::span<const std::int64_t> index, std::span<const double> time,
                               ForceHold hold)
{
    GriddedChannels grid;
    if (index.empty())
        return grid;
    const std::int64_t points = index.back() - index.front() + 1;
    grid.force.assign(static_cast<std::size_t>(points), 0.0);
    grid.position.assign(static_cast<std::size_t>(points), 0.0);
    std::vector<bool> measured(static_cast<std::size_t>(points), false);
    std::vector<double> onGrid(time.begin(), time.end()); // from the grid's first point
    for (double& at : onGrid)
        at -= static_cast<double>(index.front());
    for (const Stretch& stretch : findStretches(index, time, points)) {
        const auto count = static_cast<std::size_t>(stretch.endPoint - stretch.firstPoint);
        const std::size_t samples = stretch.end - stretch.first;
        const std::vector<double> projected =
            projectForce(force.subspan(stretch.first, samples),
                         std::span(onGrid).subspan(stretch.first, samples), stretch.firstPoint, count, hold);
        for (std::size_t i = 0; i < count; ++i) {
            const auto n = static_cast<std::size_t>(stretch.firstPoint) + i;
            grid.force[n] = projected[i];
            grid.position[n] = positionAt(position, onGrid, stretch, static_cast<double>(n));
            measured[n] = true;
        }
    }
    finish(grid, measured);
    return grid;
}

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

Window keepLostShare(std::span<const std::int64_t> index, double largestShare)
{
    const Window all{0, index.size()};
    if (index.size() < 2)
        return all;
    const double points = static_cast<double>(index.back() - index.front()) + 1;
    if (points - static_cast<double>(index.size()) <= largestShare * points)
        return all;
    const double penalty = (1 - largestShare) / largestShare;
    Window best{0, 1};
    double bestSum = 1, sum = 1;
    std::size_t first = 0;
    for (std::size_t i = 1; i < index.size(); ++i) {
        sum -= penalty * static_cast<double>(index[i] - index[i - 1] - 1);
        if (sum <= 0) {
            sum = 0;
            first = i;
        }
        sum += 1;
        if (sum > bestSum) {
            bestSum = sum;
            best = {first, i - first + 1};
        }
    }
    return best;
}

} // namespace gripscope
