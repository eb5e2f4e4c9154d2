// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/excitation_design.h"

#include <Eigen/Core>

#include <vector>

namespace gripscope {

/// What the information matrices of one signal, one an object, on (ln m, ln b, ln k) and for noise of
/// variance 1, are worth.
class DesignCriterion {
public:
    explicit DesignCriterion(const DesignOptions& options);

    /// Mean over the objects of ln det M / 3; very negative where one is singular.
    [[nodiscard]] static double meanLogDeterminant(const std::vector<Eigen::Matrix3d>& information);

    struct Separation {
        double distance = 0;
        int first = 0, second = 0;
    };
    /// Mahalanobis distance of the nearest pair; 0 where an object's information is singular, or with one
    /// object.
    [[nodiscard]] Separation separation(const std::vector<Eigen::Matrix3d>& information) const;

private:
    double m_noiseVariance;
    std::vector<Eigen::Vector3d> m_logarithms;
    std::vector<Eigen::Matrix3d> m_scatter; ///< of the logarithms
};

} // namespace gripscope
