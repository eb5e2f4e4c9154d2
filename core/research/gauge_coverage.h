// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace gripscope {

struct GaugeCoverageOptions {
    int parts = 10, operators = 3, trials = 3;
    int missing = 0;                         ///< rows left out, the same in all runs: an unbalanced table
    std::vector<double> ratios{0.1, 0.3, 1}; ///< standard deviation of the gauge over that of the parts
    /// Shares of the gauge's variance; the rest is repeatability.
    double operatorShare = 0.2, interactionShare = 0.2;
    int runs = 500; ///< of each ratio
    int draws = 10'000;
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: as many as the machine has
    std::function<void(std::int64_t, std::int64_t)> progress;
};

enum class CoveredQuantity { Repeatability, Operator, PartOperator, Part, Gauge, Total, Categories };
inline constexpr std::size_t coveredQuantities = 7;

struct GaugeCoverageRow {
    double ratio = 0;
    int runs = 0;
    std::array<int, coveredQuantities> covered{};      ///< runs whose 95 % interval holds the truth
    std::array<double, coveredQuantities> meanWidth{}; ///< of the intervals that have an end, over the truth

    [[nodiscard]] double percent(CoveredQuantity quantity) const
    {
        return runs > 0 ? 100.0 * covered[std::size_t(quantity)] / runs : 0;
    }
};

/// How often the intervals that studyGauge() states hold the truth: crossed tables drawn from the model,
/// normal effects of known variances, the intervals of pivotalIntervals() before any pooling, as stated. A
/// run depends on the seed, the ratio and the run's number alone.
[[nodiscard]] std::vector<GaugeCoverageRow> studyGaugeCoverage(const GaugeCoverageOptions& options);

} // namespace gripscope
