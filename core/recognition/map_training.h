// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_items.h"
#include "core/recognition/parallel_chunks.h"

#include <Eigen/Core>

#include <vector>

namespace gripscope {

/// Rows and columns of a map.
struct MapGrid {
    int rows = 1, columns = 1;
    [[nodiscard]] int units() const { return rows * columns; }
    [[nodiscard]] bool neighbours(int one, int other) const; ///< of 8; not a unit with itself
};

/// The pass that a self-organising map is trained by, over one set of items.
class MapTraining {
public:
    MapTraining(const Eigen::MatrixXd& items, const MapGrid& grid);

    void setWeights(const Eigen::MatrixXd& weights) { m_weights = weights; }
    [[nodiscard]] Eigen::MatrixXd weights() const { return m_weights; }

    /// Every item to its best unit and the second best; how many changed their best unit.
    std::size_t assign();
    /// Every unit to the weighted mean of the items. A unit too far from all items keeps its weight.
    void move(double radius);

    [[nodiscard]] const std::vector<int>& best() const { return m_best; }
    [[nodiscard]] double quantizationError() const; ///< mean distance from the best unit
    [[nodiscard]] double topographicError() const;
    [[nodiscard]] double distortion(double radius) const;

private:
    struct ChunkSums {
        ItemRows sums; ///< units x features
        std::vector<double> items;
        double distance = 0;
        std::size_t changed = 0, torn = 0;
    };
    void assignChunk(const Chunk& chunk);
    [[nodiscard]] Eigen::MatrixXd neighbourhood(double radius) const;

    ItemRows m_items;
    MapGrid m_grid;
    ItemRows m_weights;
    std::vector<int> m_best;
    std::vector<ChunkSums> m_chunks;
};

} // namespace gripscope
