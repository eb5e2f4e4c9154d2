// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_figures.h"

#include <QJsonObject>

namespace gripscope {

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
