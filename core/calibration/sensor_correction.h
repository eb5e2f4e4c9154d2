// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_curve.h"

#include <array>

namespace gripscope {

/// Loads from readings, fast enough for every sample of a stream: the root of the calibration's curve within
/// its range, and straight on along the curve's end outside it (noise about the zero load lies there).
class SensorCorrection {
public:
    explicit SensorCorrection(const CalibrationCurve& curve);
    /// The one whose text() this is, to the last bit; nothing for another text.
    [[nodiscard]] static std::optional<SensorCorrection> fromText(const QString& text);
    /// Centre of the range, half the range, coefficients of powers of the scaled load.
    [[nodiscard]] QString text() const;

    /// To the last digits of the range. `reading` is finite.
    [[nodiscard]] double loadOf(double reading) const;
    /// The curve itself, continued straight outside its range: the reading that loadOf() takes to this load.
    [[nodiscard]] double readingOf(double load) const;

private:
    SensorCorrection(double center, double halfRange, const std::vector<double>& powers);
    struct Value {
        double reading = 0, slope = 0; ///< slope: per scaled load
    };
    [[nodiscard]] Value valueAt(double scaled) const;

    std::array<double, highestCalibrationDegree + 1> m_powers{}; ///< of z = (load - centre) / half range
    int m_degree = 1;
    double m_center = 0, m_halfRange = 1;
    Value m_first, m_last; ///< at z = -1 and 1
};

} // namespace gripscope
