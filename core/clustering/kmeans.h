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

/// K-means by Lloyd's iteration from greedy k-means++ starts: minimise the inertia
///     J = sum_i |x_i - c_label(i)|^2 .
/// Source: Arthur and Vassilvitskii, k-means++ (2007); Lloyd, Least squares quantization in PCM (1982); made
/// quick by Hamerly's bounds, which change no label (kmeans_assignment.h). Where the iteration stands still,
/// single items that lower J by changing their cluster do so, and it goes on.
struct KMeansOptions {
    int clusters = 4;
    int restarts = 10;
    int candidates =
        3; ///< tried for each new centre by greedy k-means++; 3 reach the optimum 99.9 % of the time
    int maxIterations = 300;
    std::uint64_t seed = 1;
    bool recordSteps = true;          ///< costs four bytes an item and step, which a million items don't want
    std::shared_ptr<WorkWatch> watch; ///< may stop it: Cancelled
    [[nodiscard]] std::optional<Error> validate() const;
};

/// The state after one assignment step: which centroids, who belongs where, J at that moment.
struct KMeansStep {
    Eigen::MatrixXd centroids;
    std::vector<int> labels;
    double inertia = 0;
};

enum class KMeansStatus { Converged, NotConverged, TooFewItems };

/// Labels are numbered by first appearance in the table, so that they do not depend on the start.
struct KMeansResult {
    KMeansStatus status = KMeansStatus::TooFewItems;
    std::vector<int> labels;
    Eigen::MatrixXd centroids; ///< clusters x features, in the space of the input
    double inertia = 0;
    int iterations = 0;
    std::vector<KMeansStep> steps; ///< of the winning start, from its centres to the end, when recorded
};

/// `items`: rows are items, columns features, all finite. The best of the restarts; the earliest of equals.
/// The seed feeds a Mersenne twister of 64 bits, so that every machine takes the same starts. Converged: no
/// item changed its cluster or wants to. Errors: Usage (options), BadInput (numbers that are not finite, or
/// too large to be squared), Cancelled.
[[nodiscard]] Expected<KMeansResult> kMeans(const Eigen::MatrixXd& items, const KMeansOptions& options = {});

/// Lloyd's iteration alone, without single moves, from given centres (one a row, as many columns as the
/// items): one run, and `clusters`, `restarts` and `seed` are not looked at. Usage when the centres do not
/// fit.
[[nodiscard]] Expected<KMeansResult> kMeansFrom(const Eigen::MatrixXd& items, const Eigen::MatrixXd& centres,
                                                const KMeansOptions& options = {});

} // namespace gripscope
