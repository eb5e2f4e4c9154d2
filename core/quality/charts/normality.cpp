// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/normality.h"

#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/math/sorted_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

constexpr std::size_t fewestForNormality = 8; // the formula of p is good from there
constexpr double largestAdjusted = 10;        // and up to there

/// log P(Z > z), also where that is below the smallest double.
double logNormalAbove(double z)
{
    if (z < 30)
        return std::log(normalAbove(z));
    // Mills's ratio: (1 - 1/z^2 + 3/z^4) phi(z)/z
    const double inverse = 1 / (z * z);
    return -z * z / 2 - std::log(z * std::sqrt(2 * std::numbers::pi)) +
           std::log1p(-inverse + 3 * inverse * inverse);
}

double chanceOfAdjusted(double a)
{
    if (a < 0.2)
        return 1 - std::exp(-13.436 + 101.14 * a - 223.73 * a * a);
    if (a < 0.34)
        return 1 - std::exp(-8.318 + 42.796 * a - 59.938 * a * a);
    if (a < 0.6)
        return std::exp(0.9177 - 4.279 * a - 1.38 * a * a);
    a = std::min(a, largestAdjusted);
    return std::exp(1.2937 - 5.709 * a + 0.0186 * a * a);
}

} // namespace

Expected<NormalityTest> testNormality(std::span<const double> values)
{
    return testNormality(sortedValues(values), summaryOf(values));
}

Expected<NormalityTest> testNormality(std::span<const double> sorted, const SubgroupSummary& summary)
{
    if (sorted.size() < fewestForNormality)
        return failure(ErrorCode::BadInput,
                       {Words::say("The test of normality"),
                        Words::say("there are %1 values").arg(sorted.size()),
                        Words::say("at least %1 were expected").arg(fewestForNormality)});
    if (!(summary.deviation > 0) || !std::isfinite(summary.deviation))
        return failure(ErrorCode::BadInput,
                       {Words::say("The test of normality"), Words::say("the values do not vary"),
                        Words::say("record more digits")});
    const std::size_t count = sorted.size();
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double below = (sorted[i] - summary.mean) / summary.deviation;
        const double above = (sorted[count - 1 - i] - summary.mean) / summary.deviation;
        sum += (2 * double(i) + 1) * (logNormalAbove(-below) + logNormalAbove(above));
    }
    const double n = double(count);
    NormalityTest test;
    test.statistic = -n - sum / n;
    test.adjusted = test.statistic * (1 + 0.75 / n + 2.25 / (n * n));
    test.p = chanceOfAdjusted(test.adjusted);
    return test;
}

} // namespace gripscope
