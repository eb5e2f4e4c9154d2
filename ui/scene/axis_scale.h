// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace gripscope {

/// How one quantity is shown along an axis: in the unit that keeps its numbers short, between round bounds,
/// with round ticks. `low`, `high` and `ticks` are in the quantity's own unit; the text of a tick is in
/// `unit`.
struct AxisScale {
    QString name;      ///< "Mass m"
    QString unit;      ///< as shown: "g", "kN/m"; empty: units as printed
    double factor = 1; ///< shown number = quantity * factor
    double low = 0, high = 1;
    double step = 0.2;
    std::vector<double> ticks;

    /// 0 at low, 1 at high.
    [[nodiscard]] double unitPosition(double value) const { return (value - low) / (high - low); }
    [[nodiscard]] double valueAt(double position) const { return low + position * (high - low); }
    [[nodiscard]] QString title() const;                  ///< "Mass m (g)"
    [[nodiscard]] QString tickText(double value) const;   ///< as many digits as the step asks for
    [[nodiscard]] QString valueText(double value) const;  ///< four significant digits with unit
    [[nodiscard]] QString numberText(double value) const; ///< three, without unit
};

/// A scale that holds [low, high] between round bounds, with at most `most` steps. An empty or reversed range
/// is widened around its middle. `unit` is a unit of core/signal/units.h; "1" shows none.
[[nodiscard]] AxisScale axisScale(const QString& name, const QString& unit, double low, double high,
                                  int most = 5);

} // namespace gripscope
