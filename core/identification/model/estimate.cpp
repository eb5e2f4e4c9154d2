// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/estimate.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

QString toString(EstimateStatus status)
{
    switch (status) {
    case EstimateStatus::Converged:
        return QStringLiteral("converged");
    case EstimateStatus::NotConverged:
        return QStringLiteral("not_converged");
    case EstimateStatus::NotIdentifiable:
        return QStringLiteral("not_identifiable");
    case EstimateStatus::NoPhysicalMapping:
        return QStringLiteral("no_physical_mapping");
    case EstimateStatus::TooFewSamples:
        return QStringLiteral("too_few_samples");
    case EstimateStatus::NotApplicable:
        return QStringLiteral("not_applicable");
    }
    return {};
}

std::optional<Eigen::Vector3d> Estimate::standardErrors() const
{
    if (!covariance)
        return std::nullopt;
    return covariance->diagonal().cwiseMax(0.0).cwiseSqrt();
}

std::optional<double> MotionEstimate::standardError(MotionParameter parameter) const
{
    const std::vector<MotionParameter> own = terms.parameters();
    const Eigen::Index at = std::ranges::find(own, parameter) - own.begin();
    if (at >= covariance.rows())
        return std::nullopt;
    return std::sqrt(std::max(0.0, covariance(at, at)));
}

std::optional<MotionEstimate> motionOf(const Estimate& estimate)
{
    if (estimate.motion || !estimate.parameters)
        return estimate.motion;
    MotionEstimate motion;
    motion.values[MotionParameter::Mass] = estimate.parameters->m;
    motion.values[MotionParameter::Damping] = estimate.parameters->b;
    motion.values[MotionParameter::Stiffness] = estimate.parameters->k;
    if (estimate.covariance)
        motion.covariance = *estimate.covariance;
    return motion;
}

std::optional<CorrectedParameters> withoutGripper(const MassDampingStiffness& measured,
                                                  const Eigen::Matrix3d& covariance,
                                                  const GripperBaseline& baseline)
{
    const Eigen::Vector3d own(baseline.parameters.data());
    const Eigen::Vector3d ownErrors(baseline.standardErrors.data());
    const Eigen::Vector3d object = measured.vector() - own;
    CorrectedParameters corrected;
    corrected.parameters = {object(0), object(1), object(2)};
    corrected.covariance = covariance;
    corrected.covariance.diagonal() += ownErrors.cwiseAbs2();
    if (!(object.array() > 0).all() || !object.allFinite() || !corrected.covariance.allFinite())
        return std::nullopt;
    return corrected;
}

} // namespace gripscope
