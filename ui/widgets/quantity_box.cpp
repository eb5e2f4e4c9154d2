// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/quantity_box.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

QuantityBox::QuantityBox(const ShownUnit& unit, std::pair<double, double> range_si, double resolution_si,
                         QWidget* parent)
    : QDoubleSpinBox(parent), m_range_si(range_si), m_factor(unit.factor)
{
    // Rounding errors of the factor do not ask for a digit more.
    constexpr double slack = 1e-6;
    setDecimals(std::max(0, int(std::ceil(-std::log10(resolution_si * m_factor) - slack))));
    setRange(range_si.first * m_factor, range_si.second * m_factor);
    setSuffix(QChar(QChar::Nbsp) + unit.unit);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_setting)
            m_si.reset();
    });
}

double QuantityBox::si() const
{
    return m_si.value_or(value() / m_factor);
}

void QuantityBox::setSi(double value)
{
    m_setting = true;
    m_si = std::clamp(value, m_range_si.first, m_range_si.second);
    setValue(value * m_factor);
    m_setting = false;
}

} // namespace gripscope
