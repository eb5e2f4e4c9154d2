// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/scatter.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// Sums of squares and products of a type's squeezes about their mean, in coordinates where the covariance
/// all types are thought to share is the identity, over `degreesOfFreedom`.
struct OwnScatter {
    LogMatrix sum = Eigen::Matrix3d::Zero();
    double degreesOfFreedom = 0;
};

/// How alike the covariances of types are: each is taken for a draw from an inverse Wishart distribution
/// about the shared one, with this many degrees of freedom (more than p + 1, so that it has a mean). By
/// maximum marginal likelihood over a fixed list; nothing (they are all the same) unless that is e^2 times as
/// likely, which types that are the same pass one time in forty. (Greene and Rayens, Partially pooled
/// covariance matrix estimation in discriminant analysis, Communications in Statistics 1989.)
[[nodiscard]] std::optional<double> degreesOfLikeness(const std::vector<OwnScatter>& types);
/// The same for scatters that need not be those of types; also for a single one.
[[nodiscard]] std::optional<double> likelyDegrees(const std::vector<OwnScatter>& scatters);

/// The type's own covariance in those coordinates, ((nu - p - 1) I + A) / (nu + f), nu of likeness and A over
/// f: with nu + f degrees of freedom its predictive Student t is the exact one of that prior.
[[nodiscard]] LogMatrix ownCovariance(const OwnScatter& type, double likeness);

/// Degrees of freedom to go with it where the shared covariance has v and comes from so many types.
[[nodiscard]] double ownDegreesOfFreedom(const OwnScatter& type, double likeness, double shared,
                                         double types);

/// Scatter that is alike in all coordinates (log m, log b and log k) and binds none to another, S = t I: one
/// number to be known instead of p (p + 1) / 2, so that few squeezes already tell much of it. t is such that
///     tr((t I + C)^-1 (S + C)) = p.
/// Nothing when the squeezes speak against it: when a scatter of another shape (an inverse Wishart
/// distribution about this one) is e^2 times as likely, which alike scatter passes one time in forty, or when
/// nothing is known of the scatter. Uses between, noise, total and degreesOfFreedom.
[[nodiscard]] std::optional<double> alikeVariance(const Scatter& scatter);

} // namespace gripscope
