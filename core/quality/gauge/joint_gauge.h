// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/source_sums.h"

namespace gripscope {

/// One combination of the values in which parts and gauge are both uncorrelated with the other combinations.
struct JointDirection {
    double ratio = 0;        ///< lambda: variance of the parts over that of the gauge along it
    double kinds = 1;        ///< sqrt(1 + 2 lambda)
    Eigen::VectorXd weights; ///< of the values, scaled to gauge variance 1
};

/// Several values judged together.
struct JointGauge {
    Eigen::MatrixXd part, gauge;            ///< covariances, negative directions taken as 0
    std::vector<JointDirection> directions; ///< the most telling first
    double kinds = 1;                       ///< product over the directions
    bool partProjected = false;             ///< a direction of the parts' covariance was negative
};

/// How many kinds of part can be told apart in the space of all values:
///     kinds = product over i of sqrt(1 + 2 lambda_i) = sqrt(det(gauge + 2 part) / det(gauge)),
/// lambda_i the generalised eigenvalues of part v = lambda gauge v. For one value that is Wheeler's
/// discrimination ratio (Wheeler and Lyday 1989, Evaluating the Measurement Process), close to sqrt(2 lambda)
/// where that is large; each factor is at least 1, so that a value that tells nothing takes nothing away.
/// A volume that counts is what it is: of kinds spread evenly, not of corners that no part fills. The
/// covariances are the multivariate method of moments from `sums` (mean squares and products, as in MANOVA),
/// each taken to the nearest that is not negative, in the metric of repeatability (Amemiya 1985, The American
/// Statistician 39). Nothing is said where the gauge's covariance is singular: a value that never scatters,
/// or that others determine.
[[nodiscard]] std::optional<JointGauge> jointGauge(const SourceSums& sums);

} // namespace gripscope
