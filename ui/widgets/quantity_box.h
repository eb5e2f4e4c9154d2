// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"

#include <QDoubleSpinBox>

#include <optional>
#include <utility>

namespace gripscope {

/// A field for a number that the program keeps in SI and a person types in a unit that they read. What nobody
/// has typed comes out as it went in: showing 30 N as 6.744 lbf does not make it 29.999 N, and what was typed
/// in another unit before does not change either.
class QuantityBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    /// `range_si` and `resolution_si` (the finest step to be typed) in SI.
    QuantityBox(const ShownUnit& unit, std::pair<double, double> range_si, double resolution_si,
                QWidget* parent = nullptr);
    /// From here on another quantity is typed; what stood there means nothing any more.
    void setQuantity(const ShownUnit& unit, std::pair<double, double> range_si, double resolution_si);
    [[nodiscard]] double si() const; ///< within the range
    /// Tells by valueChanged() also where the text stays as it is.
    void setSi(double number);

private:
    std::pair<double, double> m_range_si;
    double m_factor = 1;
    std::optional<double> m_si; ///< as set; nothing once it was typed over
    bool m_setting = false;
};

} // namespace gripscope
