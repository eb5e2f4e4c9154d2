// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/baseline.h"

namespace gripscope {

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
