// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/type_model.h"

#include <optional>

namespace gripscope {

/// The control charts of one type; see findDrift().
class SelfStartingChart {
public:
    /// `models` have at least 3 degrees of freedom; `place` of the type in them.
    SelfStartingChart(const TypeModels& models, std::size_t place, double weight);

    /// One more squeeze, as log(m, b, k), with its own covariance there.
    void add(const Eigen::Vector3d& log, const std::optional<Eigen::Matrix3d>& noise);

    [[nodiscard]] Eigen::Vector3d average() const { return m_each; }
    [[nodiscard]] double tSquared() const; ///< |average of the joint scores|^2 (2 - w) / w
    [[nodiscard]] int squeezes() const { return m_squeezes; }

private:
    const TypeModels& m_models;
    std::size_t m_place;
    double m_weight;
    Eigen::Vector3d m_mean;                          ///< of all squeezes so far
    Eigen::Matrix3d m_meanCovariance;                ///< where the covariance of a squeeze is known
    Eigen::Matrix3d m_sum = Eigen::Matrix3d::Zero(); ///< of whitened residuals and what enrolment stands for
    double m_degrees = 0;                            ///< behind it; 0 before the first squeeze
    Eigen::Vector3d m_each = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_joint = Eigen::Vector3d::Zero();
    int m_squeezes = 0;
};

} // namespace gripscope
