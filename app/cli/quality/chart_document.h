// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/chart_study.h"
#include "core/quality/charts/hotelling_chart.h"
#include "core/quality/charts/run_length.h"

#include <QJsonObject>

namespace gripscope::cli {

/// A chart and what it is worth.
struct DrawnChart {
    ChartStudy study;
    RunLengths runLengths; ///< until the first signal, and after a shift by one sigma
};

struct DrawnHotelling {
    HotellingStudy study;
    QStringList columns;
    RunLengths runLengths;
};

[[nodiscard]] QJsonObject chartDocument(const DrawnChart& chart);
[[nodiscard]] QJsonObject chartDocument(const DrawnHotelling& chart);
/// A table of points, the signals in words, and a verdict.
[[nodiscard]] QString chartText(const DrawnChart& chart);
[[nodiscard]] QString chartText(const DrawnHotelling& chart);

} // namespace gripscope::cli
