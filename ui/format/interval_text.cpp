// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/interval_text.h"

#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"

#include <QCoreApplication>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Difference of the two half widths, as a share of their mean, up to which one number says both.
constexpr double hardlyAskew = 0.1;

QString withUnit(const QString& number, const QString& unit)
{
    return unit.isEmpty() ? number : number + QChar(0x00A0) + unit;
}

} // namespace

QString intervalText(double value, const CoverageInterval& interval, const QString& unit)
{
    const double half = (interval.upper - interval.lower) / 2;
    if (!std::isfinite(value) || !std::isfinite(half) || !(half > 0))
        return formatNumber(value, std::nullopt, unit).valueWithUnit();
    if (interval.onlyUpperBound)
        return QCoreApplication::translate("gripscope::IntervalText", "at most %1")
            .arg(formatNumber(interval.upper, std::nullopt, unit, 2).valueWithUnit());
    const double askew = (interval.upper - value) - (value - interval.lower);
    if (std::abs(askew) <= hardlyAskew * half)
        return formatNumber(value, half, unit).text();
    const ShownUnit shown = shownUnit(unit, std::abs(value));
    const auto digits = [&](double number) {
        return formatNumber(number * shown.factor, half * shown.factor, {}).value;
    };
    return QCoreApplication::translate("gripscope::IntervalText", "%1 (%2 to %3)")
        .arg(withUnit(digits(value), shown.unit), digits(interval.lower), digits(interval.upper));
}

} // namespace gripscope
