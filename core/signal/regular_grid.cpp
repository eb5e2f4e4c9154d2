// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/regular_grid.h"

#include "core/signal/force_projection.h"

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

} // namespace gripscope
