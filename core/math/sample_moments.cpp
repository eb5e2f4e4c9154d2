// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/sample_moments.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

SampleMoments sampleMoments(std::span<const double> values)
{
    SampleMoments moments{values.size()};
    if (values.empty())
        return moments;
    const double first = values.front();
    const auto count = double(values.size());
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value - first));
    moments.mean = first;
    if (largest == 0)
        return moments;
    double sum = 0;
    for (const double value : values)
        sum += (value - first) / largest;
    const double centre = sum / count;
    double squares = 0, rest = 0; // the rest corrects for the rounding of the centre
    for (const double value : values) {
        const double distance = (value - first) / largest - centre;
        squares += distance * distance;
        rest += distance;
    }
    squares -= rest * rest / count;
    moments.mean = first + largest * (centre + rest / count);
    moments.sumOfSquares = largest * largest * squares;
    if (values.size() > 1)
        moments.standardDeviation = largest * std::sqrt(squares / (count - 1));
    return moments;
}

} // namespace gripscope
