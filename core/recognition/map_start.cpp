// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/map_start.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// Beyond this, more units only cost time: the grouping has all the detail that it can use.
constexpr double mostAutomaticUnits = 256;
/// The longer side is at most this many times the shorter.
constexpr double longestRatio = 4;

int sideFor(double units, int otherSide)
{
    return std::clamp(int(std::ceil(units / otherSide)), 1, std::max(mostMapUnits / otherSide, 1));
}

/// The direction of that rank, as long as the standard deviation along it; zero where there is none.
Eigen::RowVectorXd direction(const PrincipalAxes& axes, Eigen::Index rank)
{
    if (rank >= axes.deviations.size())
        return Eigen::RowVectorXd::Zero(axes.mean.size());
    return axes.directions.col(rank).transpose() * axes.deviations(rank);
}

} // namespace

MapGrid chooseGrid(const SelfOrganizingMapOptions& options, Eigen::Index items, const PrincipalAxes& axes)
{
    if (options.rows > 0 && options.columns > 0)
        return {options.rows, options.columns};
    const double units = std::clamp(std::max(5 * std::sqrt(double(items)), 4.0 * options.groups), 1.0,
                                    std::max(mostAutomaticUnits, 4.0 * options.groups));
    if (options.rows > 0)
        return {options.rows, sideFor(units, options.rows)};
    if (options.columns > 0)
        return {sideFor(units, options.columns), options.columns};
    const double second = axes.deviations.size() > 1 ? axes.deviations(1) : 0;
    const double ratio =
        axes.deviations(0) < longestRatio * second ? axes.deviations(0) / second : longestRatio;
    const int rows = std::max(int(std::sqrt(std::min(units, double(mostMapUnits)) / ratio)), 1);
    return {rows, sideFor(units, rows)};
}

Eigen::MatrixXd weightsOnPlane(const MapGrid& grid, const PrincipalAxes& axes)
{
    const auto position = [](int at, int count) { return count > 1 ? 4.0 * at / (count - 1) - 2 : 0.0; };
    const bool wide = grid.columns >= grid.rows;
    const Eigen::RowVectorXd across = direction(axes, wide ? 0 : 1);
    const Eigen::RowVectorXd down = direction(axes, wide ? 1 : 0);
    Eigen::MatrixXd weights(grid.units(), axes.mean.size());
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            weights.row(row * grid.columns + column) =
                axes.mean + position(column, grid.columns) * across + position(row, grid.rows) * down;
    return weights;
}

Eigen::MatrixXd weightsFromItems(const MapGrid& grid, const Eigen::MatrixXd& items, std::mt19937_64& random)
{
    Eigen::MatrixXd weights(grid.units(), items.cols());
    for (Eigen::Index unit = 0; unit < weights.rows(); ++unit) {
        const auto item = Eigen::Index(uniformNumber(random) * double(items.rows()));
        weights.row(unit) = items.row(std::min(item, items.rows() - 1));
    }
    return weights;
}

} // namespace gripscope
