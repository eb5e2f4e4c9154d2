// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"

#include <Eigen/Core>
#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// By how much m, b and k differ from one part of the record (or one squeeze, or one amplitude) to the next
/// beyond what the stated noise explains: what the model leaves out, as far as it changes with time and
/// amplitude.
struct ModelDiscrepancy {
    /// Of (ln m, ln b, ln k) from one part to another; zero when the parts agree. It belongs to each part and
    /// to the whole alike, undivided: more samples of the same do not average a wrong model out.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    Eigen::Vector3d degreesOfFreedom = Eigen::Vector3d::Ones(); ///< of its three variances
    int parts = 0;                                              ///< how many were compared; 0: none
    std::optional<double> agreementP; ///< p-value of the hypothesis that all parts have one m, b and k
    QString words;                    ///< what was found, or why it could not be
    [[nodiscard]] bool found() const { return covariance.trace() > 0; }
};

/// Parts whose probability of agreeing is above this are taken to agree. A true model is charged so seldom
/// that its intervals grow by 1 to 2 % on average.
inline constexpr double discrepancyLevel = 0.003;

/// From estimates of different parts, each with its own covariance. Cochran's Q in three dimensions, theta =
/// (ln m, ln b, ln k), with Student's correction for estimated variances, against F(3 (K - 1), sum of their
/// degrees of freedom); when it is significant, the between-part covariance by moments,
///     Psi = S - mean V_i, S the sample covariance of the theta_i,
/// cut to its positive part (DerSimonian and Laird 1986; Jackson, White and Riley 2013, in several
/// dimensions, unweighted), with (K - 1) (Psi_jj / S_jj)^2 degrees of freedom, at least one.
///
/// Estimates that did not converge, without a covariance or with a standard error above 25 % are left out;
/// fewer than three say nothing.
[[nodiscard]] ModelDiscrepancy discrepancyBetween(std::span<const Estimate> estimates);

/// The stretches of equal length a record is split into: 4 to 6 of at least 60 samples, 4 time constants and
/// 2 swings each; none when it is too short.
[[nodiscard]] std::vector<Window> discrepancyWindows(std::size_t samples, double sampleTime_s,
                                                     const MassDampingStiffness& parameters);

/// Estimates every window of a record on its own (`estimate` with a free initial state; any estimator) and
/// compares them. `whole` is the estimate from all samples.
[[nodiscard]] ModelDiscrepancy modelDiscrepancy(std::size_t samples, double sampleTime_s,
                                                const Estimate& whole,
                                                const std::function<Estimate(Window)>& estimate);

} // namespace gripscope
