// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/research/truth_settings.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace gripscope {

struct TruthStudyOptions {
    std::vector<TruthSetting> settings; ///< empty: truthSettings()
    int runs = 30;                      ///< of each setting
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: as many as the machine has
    std::function<void(std::int64_t, std::int64_t)> progress;
};

/// What identify() said of the squeezes of one setting. A lie: `valid`, and m, b or k more than four stated
/// standard uncertainties from the truth, k the relaxed stiffness.
struct TruthRow {
    TruthSetting setting;
    int runs = 0, valid = 0, suspect = 0, invalid = 0, lies = 0;
    int widened = 0;              ///< valid ones whose interval of k friction that may hide has doubled
    std::array<int, 3> covered{}; ///< valid ones whose 95 % interval of m, b, k holds the truth
    std::array<int, 3> coveredWidened{};  ///< of those that are widened
    std::array<double, 3> largestError{}; ///< of valid ones, in stated standard uncertainties
};

struct TruthStudy {
    std::vector<TruthRow> rows;
    int runs = 0, valid = 0, lies = 0;
    double coveredPercent = 0;        ///< of the intervals of valid ones that are not widened
    double coveredWidenedPercent = 0; ///< of those that are
    double validInFamilyPercent = 0;  ///< of the squeezes with `inFamily`
};

/// Squeezes drawn, simulated apart from the estimators (simulateRealPart()) and identified as a person would
/// by default. A run depends on the seed, the setting's name and the run's number alone.
[[nodiscard]] TruthStudy studyTruth(const TruthStudyOptions& options);

} // namespace gripscope
