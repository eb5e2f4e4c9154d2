// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/live_chart.h"
#include "core/quality/charts/within_spread.h"

namespace gripscope {

struct ChartOptions {
    ChartKind kind = ChartKind::Individuals;
    std::optional<double> target; ///< the centre; absent: the mean of the values
    std::optional<double> sigma;  ///< of one value; absent: as it shows within subgroups
    RunRules rules = RunRules::None;
    double weight = 0.2, width = 3;
    double reference = 0.5, decision = 5;
    /// The first so many points settle centre and sigma (phase 1), the others are judged by them; absent:
    /// all.
    std::optional<std::size_t> estimateFrom;
};

enum class ChartPart { Location, Spread };

struct ChartSignal {
    std::size_t point = 0; ///< from 0
    ChartPart part = ChartPart::Location;
    int rule = 1;
    std::optional<std::size_t> since; ///< CUSUM: the first point of the sum that passed its limit
    bool rising = false;              ///< CUSUM: it is the upper one; EWMA: above its limit
};

struct ChartStudy {
    ChartSetting setting;
    std::optional<WithinSpread> spread;                  ///< absent where sigma was given
    std::vector<ChartPoint> points;                      ///< one a subgroup
    std::vector<std::optional<ChartPoint>> spreadPoints; ///< as many; none on EWMA and CUSUM charts
    std::vector<ChartSignal> signalsFound;               ///< in order of points
    Findings messages;
};

/// A table of values as a control chart: centre and sigma from the values (phase 1), or as given, then each
/// point as LiveChart has it. Sigma: of i-mr by moving ranges, xbar-r by ranges, xbar-s by deviations, EWMA
/// and CUSUM as SpreadMethod::Automatic. Limits from few points are themselves uncertain: below 20 that is
/// said. Usage and BadInput as ChartSetting, withinSpread() and LiveChart have them; one subgroup alone; a
/// chart of ranges or deviations without a subgroup of two.
[[nodiscard]] Expected<ChartStudy> studyChart(const Subgroups& groups, const ChartOptions& options);

/// "Point 12: 9 points in a row on one side of the centre"
[[nodiscard]] Finding signalInWords(const ChartSignal& signal, const ChartSetting& setting);

} // namespace gripscope
