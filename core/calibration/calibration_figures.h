// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_curve.h"

#include <QJsonObject>

#include <optional>
#include <vector>

namespace gripscope {

/// What a calibration says of its sensor, beside the curve. Percentages are of the full scale, the span of
/// the curve's readings from the least to the largest load. What the points do not tell is absent.
struct CalibrationFigures {
    /// Largest distance of the curve from the straight line through its ends.
    double linearityPercent = 0;
    /// Standard deviation of readings at one load reached in the same direction, pooled over all; percent,
    /// and in units of the reading with its degrees of freedom.
    std::optional<double> repeatabilityPercent, repeatability;
    int repeatabilityDegreesOfFreedom = 0;
    /// Largest difference, at one load, of the mean readings on the way up and on the way down.
    std::optional<double> reversibilityPercent;
    /// Last reading less the first, where both are at the least load and others lie between.
    std::optional<double> zeroReturnPercent;
    /// p-value of so much misfit, were the curve true: the scatter about the curve beyond that at equal loads
    /// (F test of lack of fit; Draper and Smith, Applied Regression Analysis, ch. 2). Below 0.01 a higher
    /// degree, or a look at the points, is due.
    std::optional<double> lackOfFitProbability;
};

/// For points in the order they were taken: reached from a lower load? A repeated load keeps its direction,
/// and the first goes the way the first different one does; all are ascending where there is none.
[[nodiscard]] std::vector<bool> ascendingPoints(const std::vector<CalibrationPoint>& points);

/// Mean readings at one load, reached from below and from above.
struct UpAndDown {
    double load = 0;
    std::optional<double> up, down;
};
/// Of all loads of the points, ascending.
[[nodiscard]] std::vector<UpAndDown> upAndDown(const std::vector<CalibrationPoint>& points);

/// Points in the order they were taken: that is what tells up from down.
[[nodiscard]] CalibrationFigures calibrationFigures(const CalibrationCurve& curve,
                                                    const std::vector<CalibrationPoint>& points);

/// What becomes of single readings: each with its load, standard and expanded (95 %, Student's t)
/// uncertainty; null where it lies outside the range.
[[nodiscard]] QJsonObject loadFromReadingJson(const CalibrationCurve& curve,
                                              const std::vector<double>& readings);

/// {"points", "degree", "reading_from_load": {coefficients, standard_deviations, residual_deviation,
/// degrees_of_freedom, load_range}, "load_from_reading": .., "figures": ..}
[[nodiscard]] QJsonObject calibrationJson(const CalibrationCurve& curve,
                                          const std::vector<CalibrationPoint>& points,
                                          const std::vector<double>& readings);

} // namespace gripscope
