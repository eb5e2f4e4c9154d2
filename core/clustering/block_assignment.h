// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel_runs.h"
#include "core/clustering/cluster_items.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace gripscope {

struct ClusterSums {
    ItemRows sums;         ///< of the items, clusters x features
    Eigen::VectorXd items; ///< how many in each cluster
};

/// Items to their nearest centroid and the sums of the clusters, by measuring every distance: in blocks of
/// items whose features lie in columns, many items at once. A block of which no item changed its cluster
/// since the last assignment has its sums still; they are the same to the last bit as if they were added
/// anew.
class BlockAssignment {
public:
    BlockAssignment(const ItemRows& items, int clusters);

    /// Of a chunk of the items: labels (the last assignment's, -1 before the first) and sums; how many labels
    /// changed. Chunks may be assigned side by side.
    std::size_t assign(const Chunk& chunk, const ItemRows& centroids, std::vector<int>& labels,
                       ClusterSums& sums);

private:
    void addUp(std::size_t block, const int* labels, std::size_t count);
    [[nodiscard]] const double* columnsOf(std::size_t block) const;

    Eigen::Index m_features, m_clusters;
    std::unique_ptr<double[]> m_columns; ///< block after block
    std::vector<double> m_sums;          ///< of each block, clusters x (features and how many)
};

} // namespace gripscope
