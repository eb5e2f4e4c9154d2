// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace gripscope {

/// What a record itself says about the forces that were lost in it.
struct LostForcePrior {
    std::vector<double> force;     ///< the whole record, the lost values interpolated
    std::vector<double> deviation; ///< of each lost force from its interpolation, one standard deviation
};

/// Interpolates every gap on a straight line between its neighbours, or on a cubic through two on either
/// side, whichever fits better where the same gap is laid over measured samples. There the errors e are
/// measured as well: e^2 = a + c d^2, d the difference of the neighbours (a binary force errs only where d is
/// not zero). A variance never seen is taken for that of the force over one more than the places tried. In a
/// gap of several samples the errors may all go the same way, which counts more than their sizes: variances
/// are multiplied by the ratio measured of E (sum e)^2 to sum E e^2, 1 to the gap's length.
///
/// A force without any prior would cost much more: a response that is slow beside the sample time says
/// little about a single force. `lost` is sorted, within the record, and not all of it; the values there are
/// ignored. Deviations are positive.
[[nodiscard]] LostForcePrior lostForcePrior(const std::vector<double>& force,
                                            const std::vector<std::size_t>& lost);

} // namespace gripscope
