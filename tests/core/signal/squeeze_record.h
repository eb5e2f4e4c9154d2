// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording.h"

#include <cmath>

namespace gripscope::test {

/// A whole squeeze of can A in SI: the jaws close on nothing, touch, press up to a bias, excite, let go and
/// open. 0.5 ms a sample, held force.
struct SqueezeRecord {
    MassDampingStiffness truth{0.0396, 43, 9990};
    double sampleTime_s = 0.0005;
    std::size_t approach = 300, ramp = 100, excited = 1500, fall = 60, opening = 200; ///< samples
    double bias_N = 20, peak_N = 10;
    double speed_mPerS = 0.05, contactAt_m = 0.02;
    double forceNoise_N = 0.02, positionNoise_m = 5e-6;
    ForceHold hold = ForceHold::Zero;
    std::uint64_t seed = 1;

    [[nodiscard]] std::size_t touch() const { return approach; }
    [[nodiscard]] std::size_t contactEnd() const { return approach + 2 * ramp + excited + fall; }

    /// The force in contact: up, a rest, the excitation, down.
    [[nodiscard]] std::vector<double> contactForce() const
    {
        ExcitationOptions options;
        options.peak = peak_N;
        options.bias = bias_N;
        options.sampleTime_s = sampleTime_s;
        options.samples = excited;
        options.seed = seed;
        const std::vector<double> excitation = *makeExcitation(options);
        std::vector<double> force;
        for (std::size_t i = 0; i < ramp; ++i)
            force.push_back(bias_N * static_cast<double>(i + 1) / static_cast<double>(ramp));
        force.insert(force.end(), ramp, bias_N);
        force.insert(force.end(), excitation.begin(), excitation.end());
        const double last = excitation.empty() ? bias_N : excitation.back();
        for (std::size_t i = 0; i < fall; ++i)
            force.push_back(last * (1 - static_cast<double>(i + 1) / static_cast<double>(fall)));
        return force;
    }

    /// `sign` turns both channels round, as a gripper that counts the other way does.
    [[nodiscard]] Recording make(double sign = 1) const
    {
        Recording recording;
        recording.sampleTime_s = sampleTime_s;
        recording.hold = hold;
        const double step_m = speed_mPerS * sampleTime_s;
        for (std::size_t i = 0; i < approach; ++i) {
            recording.force.push_back(0);
            recording.position.push_back(contactAt_m - step_m * static_cast<double>(approach - i));
        }
        const std::vector<double> force = contactForce();
        const std::vector<double> position =
            simulate(truth, force, {sampleTime_s, hold, 0, 0, approach > 0 ? speed_mPerS : 0, contactAt_m});
        recording.force.insert(recording.force.end(), force.begin(), force.end());
        recording.position.insert(recording.position.end(), position.begin(), position.end());
        for (std::size_t i = 0; i < opening; ++i) {
            recording.force.push_back(0);
            recording.position.push_back(position.back() - step_m * static_cast<double>(i + 1));
        }
        finish(recording, sign);
        return recording;
    }

private:
    void finish(Recording& recording, double sign) const
    {
        GaussianNoise noise(seed + 1000);
        for (std::size_t i = 0; i < recording.size(); ++i) {
            recording.time_s.push_back(static_cast<double>(i) * sampleTime_s);
            recording.force[i] = sign * (recording.force[i] + forceNoise_N * noise());
            recording.position[i] = sign * (recording.position[i] + positionNoise_m * noise());
        }
    }
};

} // namespace gripscope::test
