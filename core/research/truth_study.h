// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/research/real_part.h"

#include <QString>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace gripscope {

/// A squeeze of a part that need not be ideal: levels of force drawn anew every `bit_s`, between bias -
/// amplitude and bias + amplitude, held; samples at even times, positions taken up to some share of a sample
/// beside them, with white noise.
struct TruthSetting {
    QString name;
    RealPart part;
    int levels = 2;
    double bias = 20, amplitude = 10; ///< N
    double bit_s = 0.005, seconds = 1, sampleTime_s = 0.0005;
    double noise_m = 1e-5;
    double jitterShare = 0; ///< standard deviation of a sample's time, in samples
    /// The identification has terms for all of it, so that it should find them.
    bool inFamily = true;
};

/// Those of physics.md's kind (friction, hysteresis, relaxation, stiffening, jitter about one can), and as
/// many of other sizes: parts of 5 to 200 Hz, sampled 100 to 6,000 times a second, other amplitudes and
/// preloads.
[[nodiscard]] std::vector<TruthSetting> truthSettings();

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
