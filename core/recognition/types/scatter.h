// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/quantity_space.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// An enrolled squeeze as the logarithms of its p quantities, with what is known about it.
struct LogSqueeze {
    LogVector x = Eigen::Vector3d::Zero();
    std::optional<LogMatrix> noise; ///< C, the identification's own covariance of x
    int part = -1;                  ///< which part of the type was squeezed; below 0: one of its own
};

/// Covariance of the p (p + 1) / 2 different entries of a symmetric matrix, 11, 22, 33, 12, 13, 23 of p = 3.
inline constexpr int mostEntries = mostDimensions * (mostDimensions + 1) / 2;
using SymmetricCovariance =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostEntries, mostEntries>;

/// How squeezes of one type differ: y = mu + d + e with e ~ N(0, C) from the identification, known, and
/// d ~ N(0, S), everything else (regrip and part), alike for all types.
///
/// S is the restricted maximum likelihood estimate. Where all C are alike that is the pooled covariance W
/// over v degrees of freedom less C, exactly; where they differ, Fisher scoring finds it (Patterson and
/// Thompson 1971). Where the squeezes scatter less than C says (W < C in some direction), S is zero there and
/// C is taken for smaller by `noiseFactor`, so that S and C together are never more than what was seen.
/// Squeezes without C are taken to have the average one; when none has, S is W and holds it.
///
/// Where parts were squeezed more than once, S = B + R, part-to-part and regrip, from the unweighted means of
/// the parts (Burdick and Graybill, Confidence Intervals on Variance Components, 1992).
struct Scatter {
    LogMatrix between = Eigen::Matrix3d::Zero();         ///< S
    LogMatrix noise = Eigen::Matrix3d::Zero();           ///< the average C, after `noiseFactor`
    LogMatrix noiseFactor = Eigen::Matrix3d::Identity(); ///< G: C counts as G C G'
    LogMatrix total = Eigen::Matrix3d::Zero();           ///< S + noise: of a squeeze like those enrolled
    LogMatrix factor = Eigen::Matrix3d::Zero();          ///< lower Cholesky factor of `total`
    SymmetricCovariance uncertainty =
        Eigen::Matrix<double, 6, 6>::Zero(); ///< of S, where `total` is the identity
    double degreesOfFreedom = 0;             ///< behind `total`; 0: nothing is known
    double shrinkage = 0;                    ///< of the pooled covariance, see pool()
    bool noiseKnown = false;
    /// B and R, where parts were squeezed more than once; B not when each type is of one part only.
    std::optional<LogMatrix> partToPart, regrip;
    std::optional<double> alikeVariance = {}; ///< see alikeVariance(); absent: S is of another shape
};

/// One element a type. The pooled covariance is shrunk towards its own diagonal, so that few squeezes do not
/// make it flat (with v < p it would be singular): W = (1 - w) W_pooled + w diag(W_pooled),
///     w = 1 / (1 + v^max(3, p)):   for p = 3 0.5 at v = 1, 0.04 at 3, 0.002 at 8.
/// It falls faster than the sampling error of W (about sqrt(2/v)), so that from v of about 8 gates keep their
/// stated rate, also when m, b and k go strongly together. In more dimensions a gate reaches to where W is
/// narrower still, and w must be smaller. `alike`: the coordinates may be compared, as m, b and k may (see
/// alikeVariance()).
[[nodiscard]] Scatter estimateScatter(const std::vector<std::vector<LogSqueeze>>& types, bool alike = true);

/// Covariance of a new squeeze about the type's true mean, S + C. Without C that of the enrolled ones. Where
/// C of the enrolled ones is not known, W holds it; a C above W (in any direction) then takes its place
/// there. A C much smaller than the enrolled ones' leaves S, a difference, badly known: as much of their
/// noise is put back as keeps max(p, v/2) degrees of freedom.
[[nodiscard]] LogMatrix covarianceOfSqueeze(const Scatter& scatter, const std::optional<LogMatrix>& noise);

/// Degrees of freedom of the Wishart distribution that is as uncertain as S + C: v for squeezes like those
/// enrolled, more when C, which is known, is most of it (Nel and van der Merwe 1986, in the invariant form of
/// Krishnamoorthy and Yu 2004).
[[nodiscard]] double degreesOfFreedom(const Scatter& scatter, const LogMatrix& covariance);

/// Covariance of the mean of a type's squeezes about the type's true mean, and the mean.
struct TypeMean {
    LogVector mean = Eigen::Vector3d::Zero();
    LogMatrix covariance = Eigen::Matrix3d::Zero();
};
/// Squeezes weighted by (S + C)^-1, parts by the number of their squeezes not at all.
[[nodiscard]] TypeMean estimateMean(const Scatter& scatter, const std::vector<LogSqueeze>& squeezes);

} // namespace gripscope
