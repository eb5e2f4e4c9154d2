// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/source_sums.h"

namespace gripscope {

/// More combinations than this take minutes where they are not balanced.
inline constexpr std::size_t mostUnbalancedCells = 1000;

/// A table by its combinations of factors: all that a likelihood or a projection needs.
struct CellTable {
    Eigen::VectorXd count;                 ///< rows in each
    Eigen::MatrixXd mean;                  ///< cells x values
    Eigen::MatrixXd within;                ///< sums of squares and products within cells
    double withinDegrees = 0;              ///< rows - cells
    std::vector<std::vector<int>> levelOf; ///< of each term: the level of each cell
};

/// `centred` as in sourceSums(), a row each of the layout's.
[[nodiscard]] CellTable cellTable(const GaugeLayout& layout, const Eigen::MatrixXd& centred);

/// The sums of an unbalanced table, each term given those that do not contain it, by orthogonal projections
/// of the cells' means weighted with their counts. A term that is determined by the others has 0 degrees of
/// freedom. BadInput for more than mostUnbalancedCells.
[[nodiscard]] std::optional<Error> projectedSums(const GaugeLayout& layout, const Eigen::MatrixXd& centred,
                                                 SourceSums& sums);

struct RestrictedLikelihoodOptions {
    int maxIterations = 500;
    double arrived = 1e-12; ///< the step still to go, in standard errors
};

struct RestrictedLikelihoodResult {
    Eigen::VectorXd variances;  ///< of the layout's terms, then repeatability; none below 0
    std::vector<bool> boundary; ///< estimated as 0, where the likelihood would have it below
    double logLikelihood = 0;   ///< up to a constant that depends on the layout alone
    int iterations = 0;
    bool converged = false;
};

/// Variance components by restricted maximum likelihood (Patterson and Thompson 1971, Biometrika 58) of
///     y ~ N(mean, V), V = sum_l variance_l Z_l Z_l' + variance_e I,   variances >= 0,
/// from the means and the scatter within cells:
///     -2 l = log|V_c| + log(1' V_c^-1 1) + y' P y + (rows - cells) log variance_e + within / variance_e,
///     P = V_c^-1 - V_c^-1 1 (1' V_c^-1 1)^-1 1' V_c^-1,   V_c = sum variance_l Z_l Z_l' + variance_e / n.
/// Fisher's scoring, near the maximum Newton's method, with an active set at zero and steps that never lower
/// l (Searle, Casella, McCulloch 1992, section 6.6). Where the table is balanced and no moments' estimate is
/// negative, the two are the same.
///
/// Equal measurements within each cell make variance_e run to 0, where it is kept at 1e-10 of the table's
/// variance and reported as 0. `converged` is false where the iterations ended first.
[[nodiscard]] RestrictedLikelihoodResult
restrictedLikelihood(const GaugeLayout& layout, const Eigen::VectorXd& values,
                     const RestrictedLikelihoodOptions& options = {});

} // namespace gripscope
