// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/research/real_part.h"
#include "core/signal/recording/recording.h"

#include <QString>

#include <cstdint>
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

/// Parts with one term each, of which that model is true, under four levels: the can without further terms;
/// with friction from none to 1 N; yielding by 5 and 30 % over 5 and 50 ms; stiffening and softening.
struct ModelSetting {
    Estimator estimator = Estimator::OutputError;
    TruthSetting squeeze;
};
[[nodiscard]] std::vector<ModelSetting> modelSettings();

/// The part's terms and their values, as estimators name them.
[[nodiscard]] MotionTerms termsOf(const RealPart& part);
[[nodiscard]] MotionValues valuesOf(const RealPart& part);

/// One squeeze of the setting, simulated apart from the estimators (simulateRealPart()), from rest under the
/// bias. The same seed gives the same force, times and noise.
[[nodiscard]] Recording drawSqueeze(const TruthSetting& setting, std::uint64_t seed);

} // namespace gripscope
