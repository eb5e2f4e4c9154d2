// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/instrument_range.h"

#include <Eigen/Core>

#include <cmath>

namespace gripscope {

std::optional<double> InstrumentRange::logVolume() const
{
    const Eigen::Vector3d low = lowest.vector();
    const Eigen::Vector3d high = highest.vector();
    if (!low.allFinite() || !high.allFinite() || !(low.minCoeff() > 0) || !((high - low).minCoeff() > 0))
        return {};
    return (high.array().log() - low.array().log()).prod();
}

} // namespace gripscope
