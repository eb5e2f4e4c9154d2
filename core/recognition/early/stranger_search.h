// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error_problem.h"
#include "core/recognition/early/linearized_evidence.h"

#include <Eigen/Core>

#include <span>

namespace gripscope {

/// A record linearised at theta = ln of m, b, k in the problem's units.
struct LinearizedRecord {
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();
    LaggedProducts products{7};
    bool finite = false;
};
/// Lost forces are the problem's interpolations, lost positions no rows.
[[nodiscard]] LinearizedRecord linearize(const OutputErrorProblem& problem, const Eigen::Vector3d& theta);

/// A box in theta.
struct ThetaRange {
    Eigen::Vector3d lowest, highest;
    [[nodiscard]] Eigen::Vector3d nearest(const Eigen::Vector3d& theta) const
    {
        return theta.cwiseMax(lowest).cwiseMin(highest);
    }
    /// Of a theta spread evenly over it.
    [[nodiscard]] Eigen::Vector3d variance() const { return (highest - lowest).cwiseAbs2() / 12; }
};

/// The likeliest theta within a range when the noise may have any of some poles: Gauss-Newton from the best
/// of some starts, the range a weak prior so that a record that has just begun has an answer too.
[[nodiscard]] LinearizedRecord searchStranger(const OutputErrorProblem& problem,
                                              std::span<const Eigen::Vector3d> starts,
                                              const ThetaRange& range, std::span<const double> poles,
                                              double ridge);

} // namespace gripscope
