// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/design_criterion.h"

#include "core/identification/response_sensitivities.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// ln det of an information matrix that is singular.
constexpr double singular = -3000;

double determinant(const Eigen::Matrix3d& a)
{
    return a.row(0).dot(a.row(1).cross(a.row(2)));
}

/// Scaled first, so that parameters known to very different accuracy do not pass for dependent.
double logDeterminant(const Eigen::Matrix3d& information)
{
    const Eigen::Vector3d diagonal = information.diagonal();
    if (!information.allFinite() || !(diagonal.minCoeff() > 0))
        return singular;
    const Eigen::Vector3d scale = diagonal.cwiseSqrt().cwiseInverse();
    const double scaled = determinant(scale.asDiagonal() * information * scale.asDiagonal());
    constexpr double smallest = 1e-13; // rounding
    return scaled > smallest ? std::max(std::log(scaled) + diagonal.array().log().sum(), singular) : singular;
}

} // namespace

DesignCriterion::DesignCriterion(const DesignOptions& options)
    : m_noiseVariance(options.noiseDeviation * options.noiseDeviation)
{
    for (const DesignObject& object : options.objects) {
        const Eigen::Vector3d p = object.mean.vector();
        m_logarithms.emplace_back(p.array().log().matrix());
        const Eigen::Vector3d inverse = p.cwiseInverse();
        m_scatter.emplace_back(inverse.asDiagonal() * object.covariance * inverse.asDiagonal());
    }
}

double DesignCriterion::meanLogDeterminant(const std::vector<Eigen::Matrix3d>& information)
{
    double sum = 0;
    for (const Eigen::Matrix3d& one : information)
        sum += logDeterminant(one) / 3;
    return information.empty() ? singular : sum / static_cast<double>(information.size());
}

DesignCriterion::Separation DesignCriterion::separation(const std::vector<Eigen::Matrix3d>& information) const
{
    std::vector<Eigen::Matrix3d> covariances;
    for (std::size_t i = 0; i < information.size(); ++i) {
        const std::optional<Eigen::Matrix3d> inverse = inverseInformation(information[i]);
        if (!inverse)
            return {};
        covariances.emplace_back(m_scatter[i] + m_noiseVariance * *inverse);
    }
    Separation nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < covariances.size(); ++i) {
        for (std::size_t j = i + 1; j < covariances.size(); ++j) {
            const std::optional<Eigen::Matrix3d> metric =
                inverseInformation((covariances[i] + covariances[j]) / 2);
            const Eigen::Vector3d apart = m_logarithms[i] - m_logarithms[j];
            const double squared = metric ? apart.dot(*metric * apart) : 0;
            if (!(squared < smallest))
                continue;
            smallest = squared;
            nearest = {std::sqrt(std::max(squared, 0.0)), static_cast<int>(i), static_cast<int>(j)};
        }
    }
    return nearest;
}

} // namespace gripscope
