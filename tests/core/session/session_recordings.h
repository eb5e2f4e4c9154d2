// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording.h"

namespace gripscope::test {

/// A held PRBS squeeze of an object, 1000 samples at 2 kHz, with 5 um of noise: true m, b, k known.
inline Recording squeezeOf(const MassDampingStiffness& object, std::uint64_t seed)
{
    ExcitationOptions excitation;
    excitation.samples = 1000;
    excitation.seed = seed;
    Recording recording;
    recording.sampleTime_s = excitation.sampleTime_s;
    recording.hold = ForceHold::Zero;
    recording.forceUnit = QStringLiteral("N");
    recording.positionUnit = QStringLiteral("m");
    recording.force = *makeExcitation(excitation);
    SimulationOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.x0 = 20 / object.k;
    recording.position = simulate(object, recording.force, options);
    GaussianNoise noise(seed);
    for (std::size_t i = 0; i < recording.force.size(); ++i) {
        recording.time_s.push_back(static_cast<double>(i) * recording.sampleTime_s);
        recording.position[i] += 5e-6 * noise();
    }
    return recording;
}

/// The same with a scatter of about 3 % between squeezes, each parameter for itself.
inline Recording scatteredSqueezeOf(const MassDampingStiffness& object, std::uint64_t seed)
{
    GaussianNoise scatter(1000 + seed);
    const auto around = [&scatter](double value) { return value * (1 + 0.03 * scatter()); };
    const double m = around(object.m), b = around(object.b), k = around(object.k);
    return squeezeOf({m, b, k}, seed);
}

/// A measurement that no estimator can use: the force never changes.
inline Recording constantForce()
{
    Recording recording = squeezeOf({0.04, 43, 9990}, 1);
    recording.force.assign(recording.force.size(), 20.0);
    recording.position.assign(recording.position.size(), 0.002);
    return recording;
}

inline constexpr MassDampingStiffness canA{0.0396, 43.0, 9990};
inline constexpr MassDampingStiffness canC{0.0301, 37.1, 3562};
inline constexpr MassDampingStiffness strangeCan{0.060, 60, 12000};

} // namespace gripscope::test
