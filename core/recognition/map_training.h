// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/kmeans_assignment.h"

#include <Eigen/Core>

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

} // namespace gripscope
