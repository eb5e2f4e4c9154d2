// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace gripscope {

/// Round numbers (1, 2 or 5 times a power of ten apart) from `low` to `high`, at most `most` of them.
struct AxisTicks {
    std::vector<double> values;
    double step = 0;
    [[nodiscard]] QString
    label(double value) const; ///< with the decimals the step needs, and a true minus sign
};
[[nodiscard]] AxisTicks roundTicks(double low, double high, int most);
/// For a low plot from -half to half with three numbers: the largest round number that is not above `half`,
/// at least two thirds of it.
[[nodiscard]] double symmetricStep(double half);
/// Decimals that multiples of `step` need, at most 9.
[[nodiscard]] int decimalsOf(double step);

struct AxisRange {
    double low = 0, high = 1;
    [[nodiscard]] double span() const { return high - low; }
};
/// The range between round numbers that holds `low` to `high` with a little air; never empty: at least
/// `leastSpan` wide.
[[nodiscard]] AxisRange roundRange(double low, double high, double leastSpan);

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
/// is widened around its middle. `unit` is a unit of core/signal/recording/units.h; "1" shows none.
[[nodiscard]] AxisScale axisScale(const QString& name, const QString& unit, double low, double high,
                                  int most = 5);

struct LogarithmicTick {
    double exponent = 0; ///< the decimal logarithm of what it stands for
    QString label;
};
/// Round numbers along an axis that holds decimal logarithms from `low` to `high`: 1, 2 and 5 times powers of
/// ten where `most` of them have room, else powers alone or every second, third... of them; within less than
/// two such numbers as on a linear axis. Beyond ten thousand either way a label says "2·10⁵".
[[nodiscard]] std::vector<LogarithmicTick> logarithmicTicks(double low, double high, int most);

struct TimeTick {
    double at = 0; ///< milliseconds since 1970, UTC
    QString label;
};

/// Round local times between two of them, at most `most`: minutes, hours, days, months or years apart. A
/// label says the time of day where they are less than a day apart, and the day at midnight.
[[nodiscard]] std::vector<TimeTick> timeTicks(double low_ms, double high_ms, int most);

} // namespace gripscope
