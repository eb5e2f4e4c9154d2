// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/scatter.h"

namespace gripscope {

/// Sums of squares and products within types and, where parts were squeezed again, within parts.
struct PartScatter {
    /// Part means about their type's mean, each mean counting once, over `betweenDegrees`; of B + h R.
    Eigen::Matrix3d between = Eigen::Matrix3d::Zero();
    int betweenDegrees = 0;
    /// Squeezes about their part's mean over `withinDegrees`; of R.
    Eigen::Matrix3d within = Eigen::Matrix3d::Zero();
    int withinDegrees = 0;
    double meanInverse = 1; ///< h: the mean over parts of 1 over the squeezes of the part
    /// The average C of the squeezes that have one; as each counts in `between` where no part repeats.
    std::optional<Eigen::Matrix3d> noise;
};

/// Squeezes of one part of a type.
using PartSqueezes = std::vector<const LogSqueeze*>;

[[nodiscard]] std::vector<PartSqueezes> byPart(const std::vector<LogSqueeze>& squeezes);
[[nodiscard]] Eigen::Vector3d meanOf(const PartSqueezes& squeezes);
[[nodiscard]] PartScatter partScatter(const std::vector<std::vector<LogSqueeze>>& types);

} // namespace gripscope
