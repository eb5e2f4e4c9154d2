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

/// Tied: one covariance for all components. Full: each has its own.
enum class MixtureCovariance { Tied, Full };

/// A mixture of `components` Gaussians,
///     p(x) = sum_j w_j N(x; mean_j, covariance_j),
/// by expectation and maximisation (EM) from K-means starts.
/// Never singular: a covariance counts features + 1 imaginary items besides its own, as many as it takes to
/// have one at all, scattered as the items scatter in the clusters of the K-means start (plus a millionth of
/// each feature's variance). That is the mode under a conjugate (inverse Wishart) prior, so EM still climbs
/// without a step back. A component with few items so leans on the others, one with many does not notice.
/// The features may be in any units: they are brought to z-scores first, and results are turned back.
/// Sources: Dempster, Laird and Rubin (1977); Fraley and Raftery, Bayesian regularization for normal mixture
/// estimation (2007), here with a prior that is scaled by the clusters, not by the whole table; short runs
/// from many starts, the best one continued: Biernacki, Celeux and Govaert (2003).
struct GaussianMixtureOptions {
    int components = 4;
    MixtureCovariance covariance = MixtureCovariance::Full;
    int restarts = 10; ///< K-means starts; those that end in the same clusters count once
    int maxIterations = 500;
    std::uint64_t seed = 1;
    bool recordSteps = true;          ///< costs four bytes an item and step
    std::shared_ptr<WorkWatch> watch; ///< may stop it: Cancelled
    [[nodiscard]] std::optional<Error> validate() const;
};

/// The parameters of a mixture, one component a row or entry.
struct MixtureParameters {
    Eigen::VectorXd weights; ///< add up to 1
    Eigen::MatrixXd means;   ///< components x features
    std::vector<Eigen::MatrixXd> covariances;
};

/// The state after one expectation step.
struct MixtureStep {
    MixtureParameters parameters;
    std::vector<int> labels; ///< the most probable component
    double logLikelihood = 0;
    double objective = 0; ///< log-likelihood and log-prior: what EM raises at each step
};

enum class MixtureStatus { Converged, NotConverged, TooFewItems };

/// Components are numbered by the first appearance of their label in the table. All in the units of the
/// items.
struct GaussianMixtureResult {
    MixtureStatus status = MixtureStatus::TooFewItems;
    MixtureParameters parameters;
    std::vector<int> labels;       ///< the most probable component of each item
    Eigen::MatrixXd probabilities; ///< items x components
    double logLikelihood = 0;      ///< natural, of all items
    double bic = 0; ///< -2 log L + (free parameters) ln(items): the lower, the better (Schwarz 1978)
    int freeParameters = 0;
    int iterations = 0;
    std::vector<MixtureStep> steps; ///< of the winning start, from K-means to the end, when recorded
};

/// `items`: rows are items, columns features, all finite. The start is the one whose short run ends
/// highest in log-likelihood and prior.
/// Converged: a step gained less than 1e-7 an item. Errors: Usage (options), BadInput (numbers that are not
/// finite, or too large to be squared), Cancelled.
[[nodiscard]] Expected<GaussianMixtureResult> gaussianMixture(const Eigen::MatrixXd& items,
                                                              const GaussianMixtureOptions& options = {});

} // namespace gripscope
