// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_correction.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

SensorCorrection::SensorCorrection(const CalibrationCurve& curve)
    : SensorCorrection(curve.leastLoad() + (curve.largestLoad() - curve.leastLoad()) / 2,
                       (curve.largestLoad() - curve.leastLoad()) / 2, curve.scaledCoefficients())
{
}

SensorCorrection::SensorCorrection(double center, double halfRange, const std::vector<double>& powers)
    : m_degree(static_cast<int>(powers.size()) - 1), m_center(center), m_halfRange(halfRange)
{
    std::copy(powers.begin(), powers.end(), m_powers.begin());
    m_first = valueAt(-1);
    m_last = valueAt(1);
}

std::optional<SensorCorrection> SensorCorrection::fromText(const QString& text)
{
    std::vector<double> numbers;
    for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        bool isNumber = false;
        numbers.push_back(word.toDouble(&isNumber));
        if (!isNumber || !std::isfinite(numbers.back()))
            return std::nullopt;
    }
    constexpr std::size_t least = 4; // centre, half range, a straight line
    if (numbers.size() < least || numbers.size() > 2 + std::size_t(highestCalibrationDegree) + 1)
        return std::nullopt;
    const SensorCorrection correction(numbers[0], numbers[1], {numbers.begin() + 2, numbers.end()});
    const bool usable = correction.m_halfRange > 0 &&
                        correction.m_first.slope * correction.m_last.slope > 0 &&
                        correction.m_first.reading != correction.m_last.reading;
    return usable ? std::optional(correction) : std::nullopt;
}

QString SensorCorrection::text() const
{
    constexpr int exact = 17;
    QString text = QString::number(m_center, 'g', exact) + u' ' + QString::number(m_halfRange, 'g', exact);
    for (int i = 0; i <= m_degree; ++i)
        text += u' ' + QString::number(m_powers[static_cast<std::size_t>(i)], 'g', exact);
    return text;
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
