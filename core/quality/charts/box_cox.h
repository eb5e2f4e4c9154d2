// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/capability.h"

namespace gripscope {

/// y = (x^lambda - 1)/lambda, log x at lambda 0, for x > 0; rises with x whatever lambda.
[[nodiscard]] double boxCox(double x, double lambda);

/// lambda from -5 to 5 that makes values most nearly normal: the maximum of
///     -n/2 log(var y) + (lambda - 1) sum log x   (Box and Cox, An analysis of transformations, 1964)
/// over x divided by their geometric mean, which changes nothing but the digits. Good to 1e-6. BadInput: a
/// value that is not above 0, fewer than 8 values, values that do not vary.
[[nodiscard]] Expected<double> bestBoxCox(std::span<const double> values);

struct TransformedCapability {
    double lambda = 1;
    double scale = 1;      ///< the geometric mean: values and limits are divided by it first
    Capability capability; ///< of transformed values against transformed limits and target
};

/// Capability of values that are not normal, but become so by a power. A lower limit of 0 or below cannot be
/// passed by values above 0, and is left out with words. Errors: as bestBoxCox() and studyCapability(); an
/// upper limit or target that is not above 0.
[[nodiscard]] Expected<TransformedCapability> studyBoxCoxCapability(const Subgroups& groups,
                                                                    const CapabilityOptions& options);

} // namespace gripscope
