// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/motion.h"
#include "core/math/gaussian.h"
#include "core/research/real_part.h"

#include <QTest>

#include <random>

namespace gripscope::test {

inline constexpr double squeezeSampleTime_s = 5e-4;

/// Can A in SI with further terms, and a squeeze of it.
struct RealSqueeze {
    RealPart part{.m = 0.04, .b = 14, .k = 10'000};
    MotionTerms terms;
    ForceHold hold = ForceHold::Zero;
    std::size_t samples = 2000;
    int levels = 4;
    double noise_m = 1e-5;
    std::uint64_t seed = 1;

    [[nodiscard]] std::vector<double> times() const
    {
        std::vector<double> all(samples);
        for (std::size_t i = 0; i < samples; ++i)
            all[i] = static_cast<double>(i) * squeezeSampleTime_s;
        return all;
    }
    /// Levels of 10 N about 20 N, a new one every 5 ms.
    [[nodiscard]] std::vector<double> force() const
    {
        std::mt19937_64 bits(seed);
        std::vector<double> all;
        double level = 0;
        for (std::size_t i = 0; i < samples; ++i) {
            if (i % 10 == 0)
                level =
                    20.0 * static_cast<double>(bits() % static_cast<std::uint64_t>(levels)) / (levels - 1) -
                    10;
            all.push_back(20 + level);
        }
        return all;
    }
    [[nodiscard]] std::vector<double> position() const
    {
        std::vector<double> all = simulateRealPart(part, times(), force(), hold, times());
        GaussianNoise noise(seed + 1000);
        for (double& x : all)
            x += 0.01 + noise_m * noise();
        return all;
    }
    [[nodiscard]] MotionOptions options() const
    {
        MotionOptions asked;
        asked.sampleTime_s = squeezeSampleTime_s;
        asked.hold = hold;
        asked.terms = terms;
        return asked;
    }
    [[nodiscard]] Estimate estimate() const { return estimateMotion(force(), position(), options()); }
    [[nodiscard]] double truthOf(MotionParameter parameter) const
    {
        switch (parameter) {
        case MotionParameter::Mass:
            return part.m;
        case MotionParameter::Damping:
            return part.b;
        case MotionParameter::Stiffness:
            return part.k;
        case MotionParameter::Friction:
            return part.friction;
        case MotionParameter::Relaxing:
            return part.relaxing;
        case MotionParameter::RelaxationTime:
            return part.relaxationTime_s;
        case MotionParameter::Cubic:
            return part.cubic;
        default:
            return 0;
        }
    }
};

inline RealSqueeze squeezeWith(double friction, double relaxing, double cubic)
{
    RealSqueeze squeeze;
    squeeze.part.friction = friction;
    squeeze.part.relaxing = relaxing;
    squeeze.part.cubic = cubic;
    squeeze.terms = {.friction = friction > 0, .relaxation = relaxing > 0, .cubic = cubic != 0};
    return squeeze;
}

inline void partRows()
{
    QTest::addColumn<double>("friction");
    QTest::addColumn<double>("relaxing");
    QTest::addColumn<double>("cubic");
    QTest::newRow("linear") << 0.0 << 0.0 << 0.0;
    QTest::newRow("friction") << 0.3 << 0.0 << 0.0;
    QTest::newRow("much friction") << 2.0 << 0.0 << 0.0;
    QTest::newRow("viscoelastic") << 0.0 << 3000.0 << 0.0;
    QTest::newRow("cubic spring") << 0.0 << 0.0 << 5e8;
    QTest::newRow("friction and viscoelastic") << 0.5 << 3000.0 << 0.0;
    QTest::newRow("friction and cubic spring") << 0.5 << 0.0 << 5e8;
}

inline RealSqueeze rowSqueeze()
{
    QFETCH(double, friction);
    QFETCH(double, relaxing);
    QFETCH(double, cubic);
    return squeezeWith(friction, relaxing, cubic);
}

} // namespace gripscope::test
