// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/hotelling_chart.h"
#include "core/quality/charts/live_chart.h"
#include "core/quality/limits/tolerance_limits.h"

#include <QString>

#include <array>
#include <optional>

namespace gripscope {

/// What is drawn: a chart each of m, b and k, or T^2 of the three together.
enum class ProcessKind { Individuals, MeanRange, MeanDeviation, Ewma, Cusum, Hotelling };
/// "i-mr", "xbar-r", "xbar-s", "ewma", "cusum", "hotelling".
[[nodiscard]] QString toString(ProcessKind kind);
[[nodiscard]] std::optional<ProcessKind> processKindFromString(const QString& text);
[[nodiscard]] std::optional<RunRules> runRulesFromString(const QString& text);
/// Means of several inspections in a row.
[[nodiscard]] bool takesSubgroups(ProcessKind kind);
/// Run rules say something there.
[[nodiscard]] bool takesRules(ProcessKind kind);
/// The chart of one quantity; individuals for T^2.
[[nodiscard]] ChartKind chartKindOf(ProcessKind kind);

/// Centre and sigma that were found in good times (phase 1) and hold from then on, in the units of the
/// values; with the chart that they were fixed on, which Inspect watches.
struct FixedLimits {
    struct Quantity {
        double centre = 0, sigma = 1; ///< of one value, as it shows within subgroups
        friend bool operator==(const Quantity&, const Quantity&) = default;
    };
    std::array<std::optional<Quantity>, 3> quantities; ///< of m, b and k
    std::optional<HotellingReference> joint;           ///< of the three together
    ProcessKind kind = ProcessKind::Individuals;
    RunRules rules = RunRules::None;
    int subgroup = 1;
    qint64 first = 0, last = 0; ///< numbers of the inspections that they come from; 0: another station's
    qint64 count = 0;           ///< so many of them
};

struct ProcessOptions {
    ProcessKind kind = ProcessKind::Individuals;
    RunRules rules = RunRules::WesternElectric;
    int subgroup = 5; ///< inspections in a row that are averaged, where takesSubgroups()
    double weight = 0.2, width = 3;
    double reference = 0.5, decision = 5;
    double falseAlarm = 0.0027; ///< T^2
    std::optional<FixedLimits> fixed;
    /// Of m, b and k, in the units of the values; no capability without.
    std::array<std::optional<ToleranceLimits>, 3> limits;

    [[nodiscard]] int size() const { return takesSubgroups(kind) ? subgroup : 1; }
};

} // namespace gripscope
