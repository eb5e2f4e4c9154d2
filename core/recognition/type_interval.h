// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/type_model.h"

#include <array>

namespace gripscope {

/// Where the squeezes of a type lie in one of m, b, k.
struct TypeInterval {
    double mean = 0; ///< geometric
    double low = 0, high = 0;
};

/// exp(mean -+ z s) for each of m, b and k in the units of the models: s the standard deviation of its
/// logarithm that all types share, z the normal quantile that leaves (1 - share)/2 on either side. Where
/// nothing is known of the scatter, low and high are the mean. Share from 0.5 to 0.9999, else 0.95.
[[nodiscard]] std::array<TypeInterval, 3> typeIntervals(const TypeModels& models, const TypeModel& type,
                                                        double share = 0.95);

} // namespace gripscope
