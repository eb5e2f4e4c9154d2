// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/live_chart.h"

#include <cstdint>

namespace gripscope {

/// How many points a chart takes, on average, until its first signal (ARL); points are independent and
/// normal, centre and sigma known, and the process is shifted from the first point on. `shift` in standard
/// deviations of what is drawn: of a mean of n, sqrt(n) times the process's.
///
/// Nothing where the numerics cannot tell: longer than 1e12 points, or a design too fine for the memory.
struct RunLength {
    double points = 0;
    double standardError = 0; ///< of a simulation; 0: computed
};

/// A Shewhart chart at 3 sigma. No rules: 1/P(|z| > 3). Western Electric: the Markov chain of what the rules
/// remember, exact (Champ and Woodall, Exact results for Shewhart control charts with supplementary runs
/// rules, Technometrics 1987). Nelson: his rules of trends know no such chain; `runs` are simulated.
[[nodiscard]] RunLength shewhartRunLength(RunRules rules, double shift, int runs = 100'000,
                                          std::uint64_t seed = 1);

enum class EwmaLimits {
    Exact, ///< that widen with time, as LiveChart draws them
    Fixed, ///< those of long ago, L sqrt(w/(2 - w)), as most tables have them
};

/// Two-sided, from the centre. The integral equation
///     l(z) = 1 + int_-h^h l(y) phi((y - (1 - w) z)/w - shift)/w dy
/// at Gauss and Legendre's places (Nystrom; Crowder, A simple method for studying run-length distributions of
/// EWMA charts, Technometrics 1987). Exact limits: backwards from where they have settled, each step with its
/// own limits (Knoth, Fast initial response features for EWMA control charts, 2005). `weight` from 0.01 to 1.
[[nodiscard]] std::optional<RunLength> ewmaRunLength(double weight, double width, double shift,
                                                     EwmaLimits limits = EwmaLimits::Exact);

/// One-sided, upwards, from 0: l(z) = 1 + l(0) Phi(k - z - shift) + int_0^h l(y) phi(y + k - z - shift) dy
/// (Page 1954; Vance 1986), by the same method.
[[nodiscard]] std::optional<RunLength> cusumRunLength(double reference, double decision, double shift);
/// Both sides together: 1/l = 1/l(shift) + 1/l(-shift) (Kemp 1961), exact where both start at 0 and have the
/// same k and h.
[[nodiscard]] std::optional<RunLength> twoSidedCusumRunLength(double reference, double decision,
                                                              double shift);

struct RunLengths {
    std::optional<RunLength> inControl, shifted;
};

/// Of the chart as it is set: nothing has moved, and the process has moved by `shift` of its sigma. Of charts
/// of values and means alone, without those of ranges and deviations.
[[nodiscard]] RunLengths runLengths(const ChartSetting& setting, double shift = 1);

} // namespace gripscope
