// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/gaussian.h"
#include "core/signal/recording/recording.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gripscope::test {

/// A slow gripper squeezes a spring, 30 rows a second: the force as it is, the opening between the fingers
/// renewed every 0.15 s and held, its clock behind the force's by `lag_s`. Closing 35 mm to the touch, 24 N,
/// opening again.
struct HeldSqueeze {
    double k_NPerM = 600; ///< above 1e5 the fingers stop where they touch, and the force rises in 0.3 s
    double interval_s = 0.15, lag_s = 0, phase_s = 0;
    double sampleTime_s = 1.0 / 30;
    double speed_mPerS = 0.0181234, largestForce_N = 24, forceNoise_N = 0.02;
    double spike_N = -60; ///< for five rows before the touch
    bool held = true;
    double lattice_m = 1e-7;
    std::uint64_t seed = 1;

    static constexpr double rest_s = 1, plateau_s = 1, open_m = 0.08, touch_m = 0.045;

    [[nodiscard]] double touch_s() const { return rest_s + (open_m - touch_m) / speed_mPerS; }
    [[nodiscard]] double loading_s() const
    {
        return k_NPerM > 1e5 ? 0.3 : largestForce_N / k_NPerM / speed_mPerS;
    }
    [[nodiscard]] double end_s() const { return touch_s() + 2 * loading_s() + plateau_s; }
    [[nodiscard]] double force(double t) const
    {
        const double rising = (t - touch_s()) / loading_s(), falling = (end_s() - t) / loading_s();
        return largestForce_N * std::clamp(std::min(rising, falling), 0.0, 1.0);
    }
    /// Without renewals.
    [[nodiscard]] double opening(double t) const
    {
        const double air = std::max(touch_s() - std::max(t, rest_s), t - end_s());
        return std::min(touch_m - force(t) / k_NPerM + speed_mPerS * std::max(air, 0.0), open_m);
    }
    /// The one with this seed: the phase anywhere, the clocks apart by up to 2.5 renewals.
    [[nodiscard]] static HeldSqueeze random(double k_NPerM, std::uint64_t seed)
    {
        std::mt19937_64 engine(seed);
        const auto share = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
        HeldSqueeze squeeze;
        squeeze.k_NPerM = k_NPerM;
        squeeze.seed = seed;
        squeeze.phase_s = squeeze.interval_s * share();
        squeeze.lag_s = 2.5 * squeeze.interval_s * (2 * share() - 1);
        return squeeze;
    }
    [[nodiscard]] Recording make() const
    {
        Recording recording;
        recording.sampleTime_s = sampleTime_s;
        recording.forceUnit = QStringLiteral("N");
        recording.positionUnit = QStringLiteral("m");
        GaussianNoise noise(seed + 1000);
        const auto rows = static_cast<int>((end_s() + 2.5) / sampleTime_s);
        const auto spike = static_cast<int>(touch_s() / sampleTime_s) - 20;
        for (int i = 0; i < rows; ++i) {
            const double t = i * sampleTime_s;
            const double seen = t - lag_s;
            const double renewed =
                held ? phase_s + interval_s * std::floor((seen - phase_s) / interval_s) : seen;
            recording.time_s.push_back(t);
            recording.force.push_back(force(t) + forceNoise_N * noise() +
                                      (i >= spike && i < spike + 5 ? spike_N : 0));
            // No drive is so even that its renewals fall on a lattice of their own.
            const double uneven_m = held ? 2e-6 * std::sin(1e3 * renewed) : 0;
            const double shown = opening(renewed) + uneven_m;
            recording.position.push_back(lattice_m > 0 ? lattice_m * std::round(shown / lattice_m) : shown);
        }
        return recording;
    }
};

} // namespace gripscope::test
