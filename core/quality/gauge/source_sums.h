// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_layout.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// Sums of squares (one value) or of squares and products (several) of each source of variation s, with what
/// is expected of them:
///     E[SS_s] = sum_l coefficients(s, l) variance_l,
/// variance_l the variance (covariance matrix) of the effects of source l, repeatability the last.
struct SourceSums {
    std::vector<GaugeSource> sources; ///< the layout's terms, then Repeatability
    Eigen::VectorXd degreesOfFreedom;
    std::vector<Eigen::MatrixXd> products; ///< one a source, values x values
    Eigen::MatrixXd coefficients;
    Eigen::MatrixXd total; ///< about the mean, with rows - 1 degrees of freedom
    Eigen::VectorXd mean;
    /// Of unbalanced tables: SS_s = |B_s' y|^2 with orthonormal B_s; kernel(s, l) = B_s' Z_l Z_l' B_s, from
    /// which the variance of SS_s follows. Empty where balanced: there SS_s / E[SS_s] is chi-squared exactly.
    std::vector<std::vector<Eigen::MatrixXd>> kernels;

    [[nodiscard]] Eigen::Index place(GaugeSource source) const; ///< -1 where it is none of them
    [[nodiscard]] double meanSquare(Eigen::Index source, Eigen::Index value = 0) const;
    /// Method of moments: the variances that make E[SS] = SS. May be negative.
    [[nodiscard]] Eigen::VectorXd momentVariances(Eigen::Index value = 0) const;
    /// The same for covariance matrices.
    [[nodiscard]] std::vector<Eigen::MatrixXd> momentCovariances() const;
    /// SS_s / E[SS_s] times this is about chi-squared with this many degrees of freedom (Satterthwaite 1946:
    /// 2 E^2 / Var at these variances, at most the rank); where balanced exactly so.
    [[nodiscard]] Eigen::VectorXd effectiveDegrees(const Eigen::VectorXd& variances) const;
};

/// `values`: a row each of the layout's, a column a value; finite. Values are centred on their mean before
/// anything is squared (two passes), so that constant leading digits cost none.
///
/// Balanced: analysis of variance of random effects, SS_s = sum over rows of (effect of s)^2 and
/// coefficients(s, l) = df_s rows / cells_l for each l that contains s (Searle, Casella, McCulloch 1992,
/// Variance Components, section 4.5). Not balanced: each term given all that do not contain it ("type II"),
/// with the expectations of those very sums (Henderson's method 3, the same book, section 5.5).
///
/// A term that others determine is left out and its message put into `layout`. Errors: BadInput where no
/// degree of freedom is left for repeatability or the parts, where all values are equal, for a table of more
/// than 1000 combinations that is not balanced.
[[nodiscard]] Expected<SourceSums> sourceSums(GaugeLayout& layout, const Eigen::MatrixXd& values);

/// A row of the table of variances. F = MS_s over the moments' estimate of E[MS_s] without the term itself:
/// where balanced with two factors the exact tests, else Satterthwaite's approximation for the denominator.
struct VarianceRow {
    GaugeSource source = GaugeSource::Part;
    double degreesOfFreedom = 0, sumOfSquares = 0, meanSquare = 0;
    std::optional<double> f, p; ///< none for repeatability, and where the denominator is not above 0
};

[[nodiscard]] std::vector<VarianceRow> varianceTable(const SourceSums& sums, Eigen::Index value = 0);

/// Of the mean of `ranges` ranges of n values each:
///     d2* = sqrt(E[mean^2]) = sqrt(d2^2 + d3^2 / ranges)
/// (Duncan 1974, Quality Control and Industrial Statistics, table D3; the AIAG manual's appendix C), and the
/// degrees of freedom of a chi that has the same mean (Patnaik 1950, Biometrika 37), as many as mean / d2*
/// has.
struct MeanRange {
    double d2Star = 0, degreesOfFreedom = 0;
};

[[nodiscard]] MeanRange meanRange(int n, int ranges);

/// The average and range method (AIAG, Measurement Systems Analysis, 4th edition, chapter III): repeatability
/// from the mean range of the trials over d2*(trials, parts x operators), operators from the range of their
/// means less repeatability / (parts trials), parts from the range of their means over d2*(parts, 1), from
/// which, as in the manual, nothing is taken off. No interaction: it counts as part of all three. In the
/// form of sourceSums(): mean squares with their equivalent degrees of freedom.
/// Errors: Usage for a design that is not crossed, balanced and of parts and operators alone, for single
/// trials and more than 1000 parts.
[[nodiscard]] Expected<SourceSums> rangeSums(const GaugeLayout& layout, const Eigen::VectorXd& values);

} // namespace gripscope
