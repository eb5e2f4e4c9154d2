// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace gripscope {

struct SampleMoments {
    std::size_t count = 0;
    double mean = 0;
    double sumOfSquares = 0; ///< sum (x - mean)^2
    /// sqrt(sumOfSquares / (count - 1)), also where the squares are too small or too large for a double; 0
    /// for one value and for none.
    double standardDeviation = 0;
};

/// In two passes, of the values less the first (exact where they share their leading digits) and scaled by
/// the largest distance: NIST's sets with 13 constant leading digits keep all that the values hold (Chan,
/// Golub and LeVeque, Algorithms for computing the sample variance, The American Statistician 37, 1983). Not
/// finite where differences of values are beyond a double.
[[nodiscard]] SampleMoments sampleMoments(std::span<const double> values);

} // namespace gripscope
