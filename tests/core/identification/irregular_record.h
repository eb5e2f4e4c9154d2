// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/identification/synthetic.h"

namespace gripscope::test {

/// Can A under a binary force, sampled by a clock that is not what it should be. The device sets or samples
/// the force at its own, irregular times; the exact response follows it from one to the next.
struct IrregularRecord {
    MassDampingStiffness truth{0.0396209, 0.1374754, 0.1022911};
    ForceHold hold = ForceHold::Zero;
    double sampleTime_s = 0.05; ///< nominal
    std::size_t samples = 400, bit = 10;
    double drift = 0;     ///< relative
    double jitter = 0;    ///< standard deviation, sample times
    double lossShare = 0; ///< of the samples, at random
    double fitPercent = 100;
    std::uint64_t seed = 1;

    [[nodiscard]] Recording make() const
    {
        Recording all = regularForce();
        GaussianNoise random(seed + 5000);
        for (std::size_t n = 0; n < samples; ++n) {
            const double off = std::clamp(jitter * random(), -0.4, 0.4);
            all.time_s.push_back((1 + drift) * sampleTime_s * (static_cast<double>(n) + off));
        }
        all.position = response(all);
        addNoise(all.position, random);
        Recording recording = slice(all, {0, 0});
        for (std::size_t n = 0; n < samples; ++n) {
            if (n > 0 && random.uniform() < lossShare)
                continue;
            recording.time_s.push_back(all.time_s[n]);
            recording.force.push_back(all.force[n]);
            recording.position.push_back(all.position[n]);
        }
        return recording;
    }

private:
    [[nodiscard]] Recording regularForce() const
    {
        Synthetic regular;
        regular.sampleTime_s = sampleTime_s;
        regular.bit_s = static_cast<double>(bit) * sampleTime_s;
        regular.samples = samples;
        regular.hold = hold;
        regular.seed = seed;
        Recording recording = regular.make();
        recording.time_s.clear();
        return recording;
    }
    [[nodiscard]] std::vector<double> response(const Recording& recording) const
    {
        std::vector<double> position{0};
        Eigen::Vector2d state = Eigen::Vector2d::Zero();
        for (std::size_t n = 0; n + 1 < samples; ++n) {
            const ExactStep<2> step = discretize(truth, recording.time_s[n + 1] - recording.time_s[n], hold);
            state =
                (step.phi * state + step.gamma0 * recording.force[n] + step.gamma1 * recording.force[n + 1])
                    .eval();
            position.push_back(state(0));
        }
        return position;
    }
    void addNoise(std::vector<double>& position, GaussianNoise& random) const
    {
        const auto count = static_cast<double>(samples);
        double mean = 0, variance = 0;
        for (const double x : position)
            mean += x / count;
        for (const double x : position)
            variance += (x - mean) * (x - mean) / count;
        for (double& x : position)
            x += fitPercent < 100 ? std::sqrt(variance) * (1 - fitPercent / 100) * random() : 0;
    }
};

} // namespace gripscope::test
