// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_correction.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

SensorCorrection::SensorCorrection(const CalibrationCurve& curve)
    : m_degree(curve.degree()), m_center(curve.leastLoad() + (curve.largestLoad() - curve.leastLoad()) / 2),
      m_halfRange((curve.largestLoad() - curve.leastLoad()) / 2)
{
    const std::vector<double> powers = curve.scaledCoefficients();
    std::copy(powers.begin(), powers.end(), m_powers.begin());
    m_first = valueAt(-1);
    m_last = valueAt(1);
}

SensorCorrection::Value SensorCorrection::valueAt(double scaled) const
{
    Value value;
    for (int i = m_degree; i >= 0; --i) {
        value.slope = value.slope * scaled + value.reading;
        value.reading = value.reading * scaled + m_powers[static_cast<std::size_t>(i)];
    }
    return value;
}

double SensorCorrection::readingOf(double load) const
{
    const double z = (load - m_center) / m_halfRange;
    if (z < -1)
        return m_first.reading + (z + 1) * m_first.slope;
    if (z > 1)
        return m_last.reading + (z - 1) * m_last.slope;
    return valueAt(z).reading;
}

double SensorCorrection::loadOf(double reading) const
{
    const double rise = m_last.reading > m_first.reading ? 1 : -1;
    if (rise * (reading - m_first.reading) <= 0)
        return m_center + m_halfRange * (-1 + (reading - m_first.reading) / m_first.slope);
    if (rise * (reading - m_last.reading) >= 0)
        return m_center + m_halfRange * (1 + (reading - m_last.reading) / m_last.slope);
    // Newton from the chord, kept within what is known to hold the root: two or three steps for real sensors.
    double low = -1, high = 1;
    double z = -1 + 2 * (reading - m_first.reading) / (m_last.reading - m_first.reading);
    constexpr int most = 100;
    constexpr double enough = 1e-15;
    for (int i = 0; i < most; ++i) {
        const Value value = valueAt(z);
        const double beyond = value.reading - reading;
        (rise * beyond > 0 ? high : low) = z;
        double next = value.slope != 0 ? z - beyond / value.slope : (low + high) / 2;
        if (!(next > low && next < high))
            next = (low + high) / 2;
        const double step = std::abs(next - z);
        z = next;
        if (step <= enough)
            break;
    }
    return m_center + m_halfRange * z;
}

} // namespace gripscope
