// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/work_watch.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// Kohonen's self-organizing map, the network that the paper names as its next step: units on a rectangular
/// grid, each with a weight (a point in the space of the items), trained so that neighbours on the grid are
/// neighbours in that space. Batch training: all items go to their best unit (the nearest), then every unit
/// moves to the mean of all items, weighted by how near their best units are on the grid,
///     w_j = sum_i h(j, best(i)) x_i / sum_i h(j, best(i)),   h = exp(-d(j, best)^2 / (2 radius^2)) .
/// The radius shrinks geometrically from half the longer side to 1/2 unit, then stays until hardly an item
/// (one in 500 at most) changes its unit. The first start lies on the plane of the two widest directions, the
/// others take items at random.
///
/// Groups: the units that hold items are merged by Ward's criterion (wardGroups()), each weighing as many
/// items as it holds.
///
/// Sources: Kohonen, Essentials of the self-organizing map (Neural Networks 37, 2013); size of the map and
/// grouping: Vesanto and Alhoniemi, Clustering of the self-organizing map (2000).
struct SelfOrganizingMapOptions {
    int rows = 0, columns = 0; ///< 0: about 5 sqrt(items) units, sides in the ratio of the widest directions
    int groups = 4;
    int restarts = 10; ///< starts; the one with the least distortion is kept
    std::uint64_t seed = 1;
    bool recordSteps = true;
    std::shared_ptr<WorkWatch> watch; ///< may stop it: Cancelled
    [[nodiscard]] std::optional<Error> validate() const;
};
/// A map has no more units than this.
inline constexpr int mostMapUnits = 1024;

/// The map after one pass over the items.
struct SelfOrganizingMapStep {
    Eigen::MatrixXd weights;      ///< units x features
    double radius = 0;            ///< of the neighbourhood that led here; 0 for the start
    double quantizationError = 0; ///< of the training items
};

enum class SelfOrganizingMapStatus { Converged, NotConverged, TooFewItems };

/// Unit of row r and column c: number r * columns + c. All in the space of the items. Groups are numbered by
/// first appearance in the table.
struct SelfOrganizingMapResult {
    SelfOrganizingMapStatus status = SelfOrganizingMapStatus::TooFewItems;
    int rows = 0, columns = 0;
    Eigen::MatrixXd weights;      ///< units x features
    std::vector<int> unitOfItem;  ///< the best unit of each item
    std::vector<int> hits;        ///< items a unit
    double quantizationError = 0; ///< mean distance of an item from its best unit
    double topographicError = 0; ///< share of items whose two best units are no neighbours (of 8) on the grid
    double distortion = 0;       ///< mean of sum_j h(j, best) |x - w_j|^2 over sum_j h(j, best), last radius
    std::vector<int> labels;     ///< group of each item
    std::vector<int> groupOfUnit; ///< of units without items: that of the nearest centroid
    Eigen::MatrixXd centroids;    ///< groups x features: means of the items; fewer rows than asked for when
                                  ///< fewer units hold items
    int iterations = 0;           ///< passes over the items
    std::vector<SelfOrganizingMapStep> steps; ///< of the winning start, when recorded

    /// U-matrix (rows x columns): mean distance of a unit's weight from those of its neighbours (up to 8).
    /// Ridges are borders between groups.
    [[nodiscard]] Eigen::MatrixXd uMatrix() const;
    /// Component plane (rows x columns): one feature of all weights.
    [[nodiscard]] Eigen::MatrixXd componentPlane(int feature) const;
};

/// `items`: rows are items, columns features, all finite and scaled by the caller so that features weigh
/// alike. Tables over 10,000 items are ordered on that many, drawn by the seed; the last passes take all.
/// Errors: Usage (options; more groups than units), BadInput (numbers that are not finite, or too large to be
/// squared), Cancelled.
[[nodiscard]] Expected<SelfOrganizingMapResult>
selfOrganizingMap(const Eigen::MatrixXd& items, const SelfOrganizingMapOptions& options = {});

} // namespace gripscope
