// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clustering/kmeans_assignment.h"
#include "core/clustering/self_organizing_map.h"
#include "core/math/decompositions.h"

#include <Eigen/Core>

#include <random>
#include <vector>

namespace gripscope {

/// Rows and columns of a map.
struct MapGrid {
    int rows = 1, columns = 1;
    [[nodiscard]] int units() const { return rows * columns; }
    [[nodiscard]] bool neighbours(int one, int other) const; ///< of 8; not a unit with itself
};

/// The passes that a self-organizing map is trained by, over one set of items. To find the best units is the
/// assignment of K-means.
class MapTraining {
public:
    /// `items`: finite, of a size whose squares neither vanish nor overflow.
    MapTraining(const Eigen::MatrixXd& items, const MapGrid& grid)
        : m_assignment(items, grid.units()), m_grid(grid)
    {
    }

    /// Sets the weights (units x features) and finds the best unit of every item.
    void place(const Eigen::MatrixXd& weights) { m_assignment.assign(weights); }
    /// Every unit to the weighted mean of the items (one too far from all of them stays), then every item to
    /// its best unit; how many changed it.
    std::size_t move(double radius);

    [[nodiscard]] Eigen::MatrixXd weights() const { return m_assignment.centroids(); }
    [[nodiscard]] const std::vector<int>& best() const { return m_assignment.labels(); }
    [[nodiscard]] double quantizationError() const; ///< mean distance from the best unit
    [[nodiscard]] double topographicError() const;  ///< share of items whose two best units are no neighbours
    [[nodiscard]] double distortion(double radius) const;

private:
    [[nodiscard]] int secondBest(Eigen::Index item) const; ///< -1 where there is but one unit
    [[nodiscard]] Eigen::MatrixXd neighbourhood(double radius) const;

    KMeansAssignment m_assignment;
    MapGrid m_grid;
};

/// The grid that the options name or leave open: about 5 sqrt(items) units, but enough for the groups; sides
/// in the ratio of the two widest directions. Vesanto and Alhoniemi (2000).
[[nodiscard]] MapGrid chooseGrid(const SelfOrganizingMapOptions& options, Eigen::Index items,
                                 const PrincipalAxes& axes);

/// Weights on the plane of the two widest directions, two standard deviations either way, the longer side of
/// the grid along the wider one (Kohonen's linear start).
[[nodiscard]] Eigen::MatrixXd weightsOnPlane(const MapGrid& grid, const PrincipalAxes& axes);

/// Items drawn at random, with replacement.
[[nodiscard]] Eigen::MatrixXd weightsFromItems(const MapGrid& grid, const Eigen::MatrixXd& items,
                                               std::mt19937_64& random);

/// Points that each stand for some items, merged two at a time until `groups` are left, always the two whose
/// merging raises the inertia least:
///     n_a n_b / (n_a + n_b) |mean_a - mean_b|^2
/// (of equals the first pair). With points that hold one item each this is Ward's clustering of the items.
/// `points`: rows, finite, their squares too; `items`: how many each stands for, above 0. Returns the group
/// of each point, numbered from 0 in order of appearance; fewer groups when there are fewer points. Takes
/// time in the square of the points, seldom more. Source: Ward, Hierarchical grouping to optimize an
/// objective function (1963).
[[nodiscard]] std::vector<int> wardGroups(const Eigen::MatrixXd& points, const Eigen::VectorXd& items,
                                          int groups);

} // namespace gripscope
