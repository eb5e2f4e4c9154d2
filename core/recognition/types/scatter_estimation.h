// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/scatter.h"

namespace gripscope {

/// Sums of squares and products within types and, where parts were squeezed again, within parts.
struct PartScatter {
    /// Part means about their type's mean, each mean counting once, over `betweenDegrees`; of B + h R.
    LogMatrix between = Eigen::Matrix3d::Zero();
    int betweenDegrees = 0;
    /// Squeezes about their part's mean over `withinDegrees`; of R.
    LogMatrix within = Eigen::Matrix3d::Zero();
    int withinDegrees = 0;
    double meanInverse = 1; ///< h: the mean over parts of 1 over the squeezes of the part
    /// The average C of the squeezes that have one; as each counts in `between` where no part repeats.
    std::optional<LogMatrix> noise;
};

/// Squeezes of one part of a type.
using PartSqueezes = std::vector<const LogSqueeze*>;

[[nodiscard]] std::vector<PartSqueezes> byPart(const std::vector<LogSqueeze>& squeezes);
[[nodiscard]] LogVector meanOf(const PartSqueezes& squeezes);
[[nodiscard]] PartScatter partScatter(const std::vector<std::vector<LogSqueeze>>& types);

/// Sum over entries a, b of covariance(a, b) tr(P E_a P E_b), E_a the symmetric unit matrices: the expected
/// square of a symmetric random matrix in the metric of P^-1.
[[nodiscard]] double expectedSquare(const SymmetricCovariance& covariance, const LogMatrix& p);

/// Covariance of the entries of V where v V is Wishart with v degrees of freedom and mean v V.
[[nodiscard]] SymmetricCovariance wishartCovariance(const LogMatrix& v, double degreesOfFreedom);

/// Covariance of the entries of T M T', from that of M's.
[[nodiscard]] SymmetricCovariance transformed(const SymmetricCovariance& covariance, const LogMatrix& t);

/// A squeeze of known noise, both in coordinates where the pooled covariance is the identity.
struct WhitenedSqueeze {
    LogVector x = Eigen::Vector3d::Zero();
    LogMatrix noise = Eigen::Matrix3d::Zero();
};

struct ScatterLikelihood {
    LogMatrix between = Eigen::Matrix3d::Zero();
    SymmetricCovariance uncertainty = Eigen::Matrix<double, 6, 6>::Zero(); ///< inverse of the expected
                                                                           ///< information
    bool converged = false;
};

/// Restricted maximum likelihood of S in y ~ N(mu_type, S + C), S without negative eigenvalues, by Fisher
/// scoring from `start`:
///     l = -1/2 sum_types (sum_j ln|S + C_j| + ln|sum_j (S + C_j)^-1| + sum_j r_j' (S + C_j)^-1 r_j).
/// (Patterson and Thompson, Recovery of inter-block information, Biometrika 1971; Searle, Casella and
/// McCulloch, Variance Components, 1992.) Not converged: too few squeezes for the entries of S.
[[nodiscard]] ScatterLikelihood maximizeLikelihood(const std::vector<std::vector<WhitenedSqueeze>>& types,
                                                   const LogMatrix& start);

} // namespace gripscope
