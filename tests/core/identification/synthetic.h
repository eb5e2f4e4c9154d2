// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording.h"

#include <algorithm>
#include <cmath>

namespace gripscope::test {

/// A record made from known truth.
struct Synthetic {
    MassDampingStiffness truth{0.0396209, 0.1374754, 0.1022911}; ///< can A in the paper's numbers
    ForceHold hold = ForceHold::Zero;
    double sampleTime_s = 0.05, bit_s = 0.5, lag_s = 0;
    std::size_t samples = 400;
    double x0 = 0, v0 = 0, offset = 0;
    double peak = 1, bias = 0;
    /// The fit that the true model would reach, percent; 100: no noise.
    double fitPercent = 100;
    std::uint64_t seed = 1;
    ExcitationKind kind = ExcitationKind::Prbs;

    [[nodiscard]] Recording make() const
    {
        ExcitationOptions excitation;
        excitation.kind = kind;
        excitation.peak = peak;
        excitation.bias = bias;
        excitation.bit_s = bit_s;
        excitation.sampleTime_s = sampleTime_s;
        excitation.samples = samples;
        excitation.seed = seed;
        excitation.oneSided = false;
        Recording recording;
        recording.sampleTime_s = sampleTime_s;
        recording.hold = hold;
        recording.forceLag_s = lag_s;
        recording.provenance[forceLagSourceKey()] = QStringLiteral("stated"); // it is known, also when zero
        recording.force = *makeExcitation(excitation);
        recording.position = simulate(truth, recording.force, {sampleTime_s, hold, lag_s, x0, v0, offset});
        for (std::size_t i = 0; i < samples; ++i)
            recording.time_s.push_back(static_cast<double>(i) * sampleTime_s);
        addNoise(recording);
        return recording;
    }

private:
    void addNoise(Recording& recording) const
    {
        if (fitPercent >= 100)
            return;
        const auto count = static_cast<double>(samples);
        double mean = 0;
        for (const double y : recording.position)
            mean += y / count;
        double variance = 0;
        for (const double y : recording.position)
            variance += (y - mean) * (y - mean) / count;
        const double deviation = std::sqrt(variance) * (1 - fitPercent / 100);
        GaussianNoise noise(seed + 1000000);
        for (double& y : recording.position)
            y += deviation * noise();
    }
};

/// Largest relative difference between two sets of parameters.
[[nodiscard]] inline double relativeDifference(const MassDampingStiffness& got,
                                               const MassDampingStiffness& want)
{
    return ((got.vector() - want.vector()).cwiseQuotient(want.vector())).cwiseAbs().maxCoeff();
}

} // namespace gripscope::test
