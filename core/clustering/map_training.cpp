// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/map_training.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace gripscope {

bool MapGrid::neighbours(int one, int other) const
{
    const int rowsApart = std::abs(one / columns - other / columns);
    const int columnsApart = std::abs(one % columns - other % columns);
    return std::max(rowsApart, columnsApart) == 1;
}

/// h of every pair of units.
Eigen::MatrixXd MapTraining::neighbourhood(double radius) const
{
    Eigen::VectorXd fall(std::max(m_grid.rows, m_grid.columns)); // by the distance along one side
    for (Eigen::Index apart = 0; apart < fall.size(); ++apart)
        fall(apart) = std::exp(-double(apart * apart) / (2 * radius * radius));
    Eigen::MatrixXd h(m_grid.units(), m_grid.units());
    for (int one = 0; one < m_grid.units(); ++one)
        for (int other = 0; other < m_grid.units(); ++other)
            h(one, other) = fall(std::abs(one / m_grid.columns - other / m_grid.columns)) *
                            fall(std::abs(one % m_grid.columns - other % m_grid.columns));
    return h;
}

std::size_t MapTraining::move(double radius)
{
    const ClusterSums own = m_assignment.sums();
    const Eigen::MatrixXd h = neighbourhood(radius);
    const Eigen::MatrixXd smoothed = h * own.sums;
    const Eigen::VectorXd mass = h * own.items;
    Eigen::MatrixXd weights = m_assignment.centroids();
    for (Eigen::Index unit = 0; unit < weights.rows(); ++unit)
        if (mass(unit) > 1e-200) // a mean of numbers that have almost vanished has no digits
            weights.row(unit) = smoothed.row(unit) / mass(unit);
    return m_assignment.assign(weights);
}

double MapTraining::quantizationError() const
{
    return m_assignment.squaredDistances().cwiseSqrt().mean();
}

int MapTraining::secondBest(Eigen::Index item) const
{
    double nearest = std::numeric_limits<double>::infinity();
    int second = -1;
    for (int unit = 0; unit < m_grid.units(); ++unit) {
        const double squared =
            (m_assignment.items().row(item) - m_assignment.centroids().row(unit)).squaredNorm();
        if (unit != best()[std::size_t(item)] && squared < nearest) {
            nearest = squared;
            second = unit;
        }
    }
    return second;
}

double MapTraining::topographicError() const
{
    std::vector<int> torn(chunkCount(best().size()), 0);
    forEachChunk(best().size(), [&](const Chunk& chunk) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
            const int second = secondBest(Eigen::Index(i));
            torn[chunk.number] += second >= 0 && !m_grid.neighbours(best()[i], second);
        }
    });
    return std::accumulate(torn.begin(), torn.end(), 0.0) / double(best().size());
}

double MapTraining::distortion(double radius) const
{
    // |x - w_j|^2 averaged over j by h is the squared distance from the weights' mean plus their scatter
    // about it; both depend on the best unit alone.
    Eigen::MatrixXd h = neighbourhood(radius);
    h.array().colwise() /= h.rowwise().sum().array().eval();
    const Eigen::MatrixXd weights = m_assignment.centroids();
    const ItemRows means = h * weights;
    Eigen::VectorXd scatter(weights.rows());
    for (Eigen::Index unit = 0; unit < weights.rows(); ++unit)
        scatter(unit) = h.row(unit).dot((weights.rowwise() - means.row(unit)).rowwise().squaredNorm());
    double sum = 0;
    for (std::size_t i = 0; i < best().size(); ++i)
        sum += scatter(best()[i]) +
               (m_assignment.items().row(Eigen::Index(i)) - means.row(best()[i])).squaredNorm();
    return sum / double(best().size());
}

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
