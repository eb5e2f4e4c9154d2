// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/identification/synthetic.h"

#include <array>
#include <functional>

namespace gripscope::test {

/// How a virtual can (SI, 2 kHz, 1 s, bits of 5 ms, 20 ± 10 N) is measured.
struct MeasuredCan {
    MassDampingStiffness truth{0.0396, 43, 9990};
    ForceHold hold = ForceHold::Zero;
    ExcitationKind kind = ExcitationKind::Prbs;
    double forceNoise_N = 0.02, forceCount_N = 0.001;
    double positionNoise_m = 5e-6, positionCount_m = 20e-6;
    std::uint64_t seed = 1;

    [[nodiscard]] Recording make() const
    {
        Synthetic synthetic;
        synthetic.truth = truth;
        synthetic.hold = hold;
        synthetic.kind = kind;
        synthetic.sampleTime_s = 0.0005;
        synthetic.bit_s = 0.005;
        synthetic.samples = 2000;
        synthetic.peak = 10;
        synthetic.bias = 20;
        synthetic.seed = seed;
        Recording recording = synthetic.make();
        recording.forceUnit = QStringLiteral("N");
        recording.positionUnit = QStringLiteral("m");
        GaussianNoise noise(seed);
        measure(recording.force, noise, forceNoise_N, forceCount_N);
        measure(recording.position, noise, positionNoise_m, positionCount_m);
        return recording;
    }

private:
    static void measure(std::vector<double>& values, GaussianNoise& noise, double deviation, double count)
    {
        for (double& value : values) {
            value += deviation * noise();
            if (count > 0)
                value = count * std::round(value / count);
        }
    }
};

/// Cans of four types, by every kind of excitation, with noise and counts from none to coarse: `runs` of
/// them, all good.
inline void forGoodSqueezes(int runs, const std::function<void(const Recording&, const QString&)>& look)
{
    constexpr std::array types{MassDampingStiffness{0.0396, 43, 9990}, MassDampingStiffness{0.0257, 29, 7640},
                               MassDampingStiffness{0.06, 12, 20000}, MassDampingStiffness{0.15, 90, 5000}};
    constexpr std::array kinds{ExcitationKind::Prbs, ExcitationKind::Prbs, ExcitationKind::Multisine,
                               ExcitationKind::Chirp, ExcitationKind::Step};
    constexpr std::array positionNoises{0.0, 1e-6, 5e-6, 20e-6, 100e-6};
    constexpr std::array positionCounts{0.0, 1e-6, 20e-6, 100e-6};
    constexpr std::array forceNoises{0.0, 0.001, 0.02, 0.5};
    constexpr std::array forceCounts{0.0, 0.001, 0.1};
    std::uint64_t state = 1;
    const auto pick = [&state](const auto& from) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return from[(state >> 33) % from.size()];
    };
    for (int run = 0; run < runs; ++run) {
        MeasuredCan can;
        can.truth = pick(types);
        can.kind = pick(kinds);
        can.hold = run % 3 == 0 ? ForceHold::First : ForceHold::Zero;
        can.positionNoise_m = pick(positionNoises);
        can.positionCount_m = pick(positionCounts);
        can.forceNoise_N = pick(forceNoises);
        can.forceCount_N = pick(forceCounts);
        can.seed = std::uint64_t(run) + 1;
        look(can.make(), QStringLiteral("run %1: excitation %2, position %3 m in steps of %4, force %5 N in "
                                        "steps of %6, hold %7, k %8")
                             .arg(run)
                             .arg(toString(can.kind))
                             .arg(can.positionNoise_m)
                             .arg(can.positionCount_m)
                             .arg(can.forceNoise_N)
                             .arg(can.forceCount_N)
                             .arg(toString(can.hold))
                             .arg(can.truth.k));
    }
}

} // namespace gripscope::test
