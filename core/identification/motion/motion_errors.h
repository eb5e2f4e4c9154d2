// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/motion_search.h"

#include <Eigen/Core>

#include <optional>

namespace gripscope {

// The errors of a motion's parameters where its search ended. `scales`: errorScales().

/// What the parameters' variances are in: 1 for a logarithm is the parameter itself.
[[nodiscard]] Eigen::VectorXd errorScales(const MotionProblem& problem, const MotionPoint& point);

/// (S'S)^-1 S' of the parameters, in the channels' units: a row a sample, zero where it was not measured.
[[nodiscard]] Eigen::MatrixXd influencesOf(const MotionProblem& problem, const MotionSearchResult& search,
                                           const MotionRows& rows, const Eigen::VectorXd& scales);

/// s^2 (J'J)^-1 of the parameters; nothing where it is no covariance.
[[nodiscard]] std::optional<Eigen::MatrixXd> whiteCovariance(const MotionProblem& problem,
                                                             const MotionSearchResult& search,
                                                             const Eigen::VectorXd& scales);

/// With what is known of the friction as one more, independent measurement of it, of this variance.
[[nodiscard]] Eigen::MatrixXd withKnownFriction(const Eigen::MatrixXd& covariance, Eigen::Index friction,
                                                double variance);

/// Under the autoregressive noise that the residuals hold, which becomes that of the estimate; nothing where
/// they hold none.
[[nodiscard]] std::optional<Eigen::MatrixXd> colouredCovariance(const MotionRows& rows,
                                                                const Eigen::VectorXd& scales,
                                                                double positionScale, Estimate& estimate);

/// How large the friction may be: the best value were it free to be below zero, and 1.645 of its errors.
/// Nothing where the motion has none.
[[nodiscard]] std::optional<double> frictionLimit(const MotionProblem& problem,
                                                  const MotionSearchResult& search, const MotionValues& found,
                                                  const Eigen::MatrixXd& covariance);

} // namespace gripscope
