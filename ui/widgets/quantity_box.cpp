// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/quantity_box.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

QuantityBox::QuantityBox(const ShownUnit& unit, std::pair<double, double> range_si, double resolution_si,
                         QWidget* parent)
    : QDoubleSpinBox(parent)
{
    setQuantity(unit, range_si, resolution_si);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_setting)
            m_si.reset();
    });
}

void QuantityBox::setQuantity(const ShownUnit& unit, std::pair<double, double> range_si, double resolution_si)
{
    m_range_si = range_si;
    m_factor = unit.factor;
    m_si.reset();
    // Rounding errors of the factor do not ask for a digit more.
    constexpr double slack = 1e-6;
    setDecimals(std::max(0, int(std::ceil(-std::log10(resolution_si * m_factor) - slack))));
    setRange(range_si.first * m_factor, range_si.second * m_factor);
    setSuffix(QChar(QChar::Nbsp) + unit.unit);
}

double QuantityBox::si() const
{
    return m_si ? *m_si : std::clamp(value() / m_factor, m_range_si.first, m_range_si.second);
}

void QuantityBox::setSi(double number)
{
    const double before = si();
    const double shownBefore = value();
    m_setting = true;
    m_si = std::clamp(number, m_range_si.first, m_range_si.second);
    setValue(number * m_factor);
    if (value() == shownBefore && *m_si != before)
        emit valueChanged(value());
    m_setting = false;
}

} // namespace gripscope
