// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/type_interval.h"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

std::array<TypeInterval, 3> typeIntervals(const TypeModels& models, const TypeModel& type, double share)
{
    if (!(share >= 0.5 && share <= 0.9999))
        share = 0.95;
    const double z = boost::math::quantile(boost::math::normal(), 0.5 + share / 2);
    std::array<TypeInterval, 3> intervals;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double spread = z * std::sqrt(std::max(0.0, models.covarianceLog(row, row)));
        const double mean = type.meanLog(row);
        intervals[i] = {std::exp(mean), std::exp(mean - spread), std::exp(mean + spread)};
    }
    return intervals;
}

} // namespace gripscope
