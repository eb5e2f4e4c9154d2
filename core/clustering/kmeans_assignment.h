// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel_runs.h"
#include "core/clustering/cluster_items.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

/// Items whose distances are measured at once.
inline constexpr Eigen::Index blockItems = 64;

/// Gives each item of a block the number of the centroid nearest to it: of equals the lowest; 0 where none is
/// at a finite distance. How many labels changed. `columns`: `features` columns of blockItems numbers each;
/// `centroids`: one a row; `labels`: blockItems numbers.
///     |x - c|^2 = ((x_1 - c_1)^2 + (x_2 - c_2)^2) + ... , added in this order without fused multiplication,
/// so that every processor finds the same to the last bit.
int assignBlock(const double* columns, Eigen::Index features, const ItemRows& centroids, int* labels);

namespace detail {
/// An item after the other, for any processor: what the other has to agree with.
int assignOneByOne(const double* columns, Eigen::Index features, const ItemRows& centroids, int* labels);
} // namespace detail

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

/// The two halves of an iteration of Lloyd: every item to its nearest centroid (of equals the lowest number),
/// and the means of the clusters. The result is that of measuring every distance, to the last bit, but most
/// distances are not measured: each item keeps an upper bound of the distance to its own centroid and a lower
/// bound of that to all others, and the triangle inequality moves both as the centroids move. Where they do
/// not tell, only centroids in a ball about the item's own are looked at, which holds its two nearest.
/// Source: Hamerly, Making k-means even faster (SDM 2010); the ball: Newling and Fleuret, Fast k-means with
/// accurate bounds (ICML 2016).
class KMeansAssignment {
public:
    /// `items`: finite, of a size whose squares neither vanish nor overflow.
    KMeansAssignment(ItemRows items, int clusters);

    /// Assigns all items; how many changed their cluster (the first time: all).
    std::size_t assign(const Eigen::MatrixXd& centroids);

    [[nodiscard]] const ItemRows& items() const { return m_items; }
    [[nodiscard]] const std::vector<int>& labels() const { return m_labels; }
    /// Of an assignment that is over.
    [[nodiscard]] std::vector<int> takeLabels() { return std::move(m_labels); }
    [[nodiscard]] const ItemRows& centroids() const { return m_centroids; }
    /// Of every item from its centroid.
    [[nodiscard]] Eigen::VectorXd squaredDistances() const;
    /// J of the labels and centroids of the last assignment.
    [[nodiscard]] double inertia() const;

    [[nodiscard]] ClusterSums sums() const;
    /// The means of the clusters. One that lost all its items moves to the item farthest from its own
    /// centroid, which lowers J most of all single moves; it stays when that item is only off by rounding.
    [[nodiscard]] Eigen::MatrixXd means() const;

private:
    struct ChunkSums : ClusterSums {
        std::size_t changed = 0;
    };
    /// How the last move of the centroids shifts the bounds.
    struct Moves {
        std::vector<double> moved;       ///< of each centroid, at least its length
        std::vector<double> halfToNext;  ///< at most half the distance to the nearest other centroid
        double most = 0, secondMost = 0; ///< of `moved`
        std::size_t farthest = 0;        ///< who moved `most`
    };
    /// The other centroids as seen from one, the nearest first.
    struct Neighbour {
        double distance = 0; ///< at most the true one
        int centroid = 0;
    };
    [[nodiscard]] double squaredDistanceOf(Eigen::Index item) const;
    [[nodiscard]] Moves movesTo(const ItemRows& centroids) const;
    void findNeighbours();
    template <int Features>
    void assignChunk(const Chunk& chunk, const Moves& moves);
    template <int Features>
    int nearestCentroid(std::size_t item, Eigen::ArrayXd& distances);
    /// The same for an item with a cluster, whose m_upper is as close as can be; `squared` is its distance.
    template <int Features>
    int nearestInBall(std::size_t item, double squared);
    void keepBounds(std::size_t item, double nearestSquared, double secondSquared);

    ItemRows m_items;
    ItemRows m_centroids;
    Eigen::ArrayXXd m_columns; ///< the centroids, feature by feature
    std::vector<int> m_labels; ///< -1 before the first assignment
    /// With few centroids: every distance is sooner measured, many items at once, than bounds are kept.
    std::optional<BlockAssignment> m_blocks;
    std::vector<double> m_upper, m_lower;             ///< distances, not squares
    std::vector<std::vector<Neighbour>> m_neighbours; ///< of each centroid; empty: it does not pay
    std::vector<ChunkSums> m_chunks;
    double m_rounding = 0;           ///< what a mean of items in one place may be off it
    double m_grow = 1, m_shrink = 1; ///< room for rounding, so that the bounds are bounds
};

} // namespace gripscope
