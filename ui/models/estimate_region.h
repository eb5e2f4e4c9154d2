// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/uncertainty_budget.h"

#include <QList>
#include <QPointF>

#include <array>
#include <optional>
#include <vector>

namespace gripscope {

/// The joint 95 % confidence region of (m, b, k) of one estimate,
///     (theta - estimate)' C^-1 (theta - estimate) <= 3 F(95 %; 3, degrees of freedom),
/// and where the other estimators' answers lie, all in percent of the estimate (Seber and Wild 1989, section
/// 5.1). What is drawn is its shadow on a plane of two parameters: the pair (i, j) of C with the same right
/// side, larger than the joint region of that pair alone.
struct EstimateRegion {
    struct Point {
        Estimator estimator = Estimator::OutputError;
        std::array<double, 3> percent{}; ///< deviation of m, b, k
    };
    Estimator estimator = Estimator::OutputError;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of (m, b, k), percent squared
    double radius = 0;                                    ///< square root of the right side above
    std::vector<Point> others;                            ///< converged estimates, the region's own not

    [[nodiscard]] double correlation(int i, int j) const;
    /// Half the width of the region along one parameter, percent.
    [[nodiscard]] double extent(int parameter) const;
    /// The shadow's outline on the plane of two parameters (horizontal, vertical), closed, percent.
    [[nodiscard]] QList<QPointF> outline(int horizontal, int vertical, int points = 96) const;
};

/// Around the recommended estimate with its own covariance: noise alone. Nothing without parameters and a
/// covariance that is positive definite.
[[nodiscard]] std::optional<EstimateRegion> estimateRegion(const Identification& identification);
/// With the budget's covariance, in percent of its parameters (those without the empty gripper).
[[nodiscard]] std::optional<EstimateRegion> estimateRegion(const Identification& identification,
                                                           const UncertaintyBudget& budget);

/// What the largest of the three correlation coefficients does to m, b and k, in words.
[[nodiscard]] QString correlationWords(const EstimateRegion& region);

} // namespace gripscope
