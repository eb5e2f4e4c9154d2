// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/correlation.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace gripscope {

/// What a record, linearised about a point in (ln m, ln b, ln k), says under noise of one pole: columns are
/// nuisances (start, offset), the three sensitivities, the residual.
struct ReducedRecord {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero(); ///< of noise variance 1, nuisances taken out
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();       ///< sensitivities times residual, likewise
    double residual = 0;                                   ///< squared, with the best nuisances
    double logDeterminant = 0;                             ///< of the nuisances' own information
};

/// `ridge` is added to the nuisances' information: a prior so wide that it decides nothing, and makes them
/// determined when a record has just begun.
[[nodiscard]] ReducedRecord reduceRecord(const LaggedProducts& products, double pole, double ridge);

/// Where m, b, k may be, about the point of linearisation: Gaussian in the logarithms.
struct LogPrior {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< mean less the point
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// A pole and deviations of the driving noise.
struct NoiseNode {
    double pole = 0;
    std::vector<double> deviations;
};

struct LinearizedEvidence {
    /// Logarithm of the record's density for each deviation of each node, in their order; but for a constant
    /// that depends on the number of rows alone.
    std::vector<double> log;
    /// The likeliest m, b, k given the record: the step from the point, at the node where `log` is largest.
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
};

/// The density of the residuals under the prior, nuisances and m, b, k integrated out:
///     log p = s/2 ln(1 - pole^2) - n ln d - ln|N|/2 - ln|1 + S A / d^2|/2 - Q / (2 d^2),
///     Q = r - 2 c'a + a'A a - c*' (A + d^2 S^-1)^-1 c*,   c* = c - A a,
/// with d the deviation, A, c, r, ln|N| the reduced record, a and S the prior, s the number of stretches.
/// Flat in the nuisances, but for the ridge (Murphy, Machine Learning, section 4.6.1: integrating out).
[[nodiscard]] LinearizedEvidence linearizedEvidence(const LaggedProducts& products, const LogPrior& prior,
                                                    std::span<const NoiseNode> noise, double ridge);

} // namespace gripscope
