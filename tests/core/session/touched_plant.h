// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random_stream.h"
#include "core/session/inspect/automatic_squeeze.h"

namespace gripscope::test {

using SqueezeWait = AutomaticSqueeze::State;

inline constexpr double idleNoise = 0.02, partForce = 0.5; ///< 25 standard deviations

/// A gripper and a screen in virtual time: samples at 2 kHz, a step each 16 ms.
class TouchedPlant {
public:
    AutomaticSqueeze machine;
    AutomaticSqueeze::Conditions conditions{true, true, false};
    double force = 0, drift = 0; ///< drift: a second
    double sampleNoise = idleNoise;
    bool moving = false, silent = false;
    int squeezes = 0, countdowns = 0;
    AutomaticSqueeze::Decision last;

    explicit TouchedPlant(const AutomaticSqueezeOptions& options = {}) : machine(options) {}

    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds / stepEach_s + 0.5); ++i)
            step(stepEach_s);
    }
    /// Samples go on, and nobody asks.
    void freeze(double seconds) { step(seconds); }
    void lose(int samples) { m_sequence += static_cast<std::uint64_t>(samples); }
    /// What is not squeezed in two seconds and more is not squeezed.
    void runUntilCounting()
    {
        for (int i = 0; i < 200 && last.state != SqueezeWait::Counting; ++i)
            step(stepEach_s);
    }
    [[nodiscard]] SqueezeWait state() const { return last.state; }
    [[nodiscard]] double now() const { return m_now_s; }

private:
    static constexpr double stepEach_s = 0.016, sample_s = 0.0005;
    void step(double seconds)
    {
        const SqueezeWait before = last.state;
        const int samples = static_cast<int>(seconds / sample_s + 0.5);
        for (int i = 0; i < samples; ++i) {
            ++m_sequence;
            m_now_s += sample_s;
            force += drift * sample_s;
            if (!silent)
                machine.take({m_sequence, m_now_s, force + sampleNoise * m_random.normal(), moving});
        }
        last = machine.step(m_now_s, conditions);
        squeezes += last.squeeze ? 1 : 0;
        countdowns += last.state == SqueezeWait::Counting && before != SqueezeWait::Counting ? 1 : 0;
    }
    RandomStream m_random{5, 1, 1};
    std::uint64_t m_sequence = 0;
    double m_now_s = 0;
};

/// At rest, and known to be.
inline TouchedPlant plantAtRest()
{
    TouchedPlant plant;
    plant.run(1.5);
    return plant;
}

/// A part touches, and its countdown runs.
inline TouchedPlant plantCounting()
{
    TouchedPlant plant = plantAtRest();
    plant.force = partForce;
    plant.runUntilCounting();
    return plant;
}

/// What a squeeze is to the machine, whoever asked for it.
inline void squeezeOnce(TouchedPlant& plant)
{
    plant.conditions.squeezing = plant.moving = true;
    plant.run(0.5);
    plant.conditions.squeezing = plant.moving = false;
}

} // namespace gripscope::test
