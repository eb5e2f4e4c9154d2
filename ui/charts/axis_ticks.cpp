// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/axis_ticks.h"

#include "core/base/words.h"
#include "ui/format/shown_unit.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

double roundStep(double span, int most)
{
    const double raw = span / std::max(1, most - 1);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double multiple : {1.0, 2.0, 5.0, 10.0})
        if (multiple * power >= raw * (1 - 1e-9))
            return multiple * power;
    return 10 * power;
}

} // namespace

QString AxisTicks::label(double value) const
{
    const int decimals = decimalsOf(step);
    const double clean = std::abs(value) < step / 1e6 ? 0 : value;
    return Words::number(clean, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

AxisTicks roundTicks(double low, double high, int most)
{
    AxisTicks ticks;
    if (!(high > low) || !std::isfinite(low) || !std::isfinite(high))
        return ticks;
    ticks.step = roundStep(high - low, std::max(2, most));
    const double first = std::ceil(low / ticks.step - 1e-6);
    const double last = std::floor(high / ticks.step + 1e-6);
    for (double i = first; i <= last; i += 1)
        ticks.values.push_back(i * ticks.step);
    return ticks;
}

namespace {

QString superscript(int number)
{
    static const QString digits = u"\u2070\u00B9\u00B2\u00B3\u2074\u2075\u2076\u2077\u2078\u2079"_s;
    QString text;
    for (const QChar letter : QString::number(number))
        text += letter == u'-' ? QChar(0x207B) : digits[letter.digitValue()];
    return text;
}

/// `multiple` times ten to the power.
LogarithmicTick logarithmicTick(int multiple, int power)
{
    constexpr int plainPowers = 4; // written out up to there
    LogarithmicTick tick{power + std::log10(double(multiple)), {}};
    if (std::abs(power) <= plainPowers)
        tick.label = Words::number(multiple * std::pow(10.0, power), 'f', std::max(0, -power));
    else if (multiple == 1)
        tick.label = u"10"_s + superscript(power);
    else
        tick.label = u"%1\u00B710%2"_s.arg(multiple).arg(superscript(power));
    return tick;
}

std::vector<LogarithmicTick> powerTicks(double low, double high, const std::vector<int>& multiples, int every)
{
    constexpr double rounding = 1e-9;
    std::vector<LogarithmicTick> ticks;
    const int first = int(std::ceil(low - rounding)); // which shows, however few do
    for (int power = first - every; power <= int(std::ceil(high)); power += every) {
        for (const int multiple : multiples) {
            LogarithmicTick tick = logarithmicTick(multiple, power);
            if (tick.exponent >= low - rounding && tick.exponent <= high + rounding)
                ticks.push_back(std::move(tick));
        }
    }
    return ticks;
}

} // namespace

std::vector<LogarithmicTick> logarithmicTicks(double low, double high, int most)
{
    constexpr double farthest = 300; // what a number holds
    if (!(high > low) || !(std::abs(low) < farthest) || !(std::abs(high) < farthest))
        return {};
    const auto room = std::size_t(std::max(2, most));
    std::vector<LogarithmicTick> ticks = powerTicks(low, high, {1, 2, 5}, 1);
    for (int every = 1; ticks.size() > room; ++every)
        ticks = powerTicks(low, high, {1}, every);
    if (ticks.size() >= 2)
        return ticks;
    const AxisTicks linear = roundTicks(std::pow(10.0, low), std::pow(10.0, high), int(room));
    std::vector<LogarithmicTick> close;
    for (const double value : linear.values)
        if (value > 0)
            close.push_back({std::log10(value), linear.label(value)});
    return close.size() > ticks.size() ? close : ticks;
}

double symmetricStep(double half)
{
    if (!(half > 0) || !std::isfinite(half))
        return 0;
    const double power = std::pow(10.0, std::floor(std::log10(half) + 1e-9));
    double step = power;
    for (const double multiple : {1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (multiple * power <= half * (1 + 1e-9))
            step = multiple * power;
    return step;
}

int decimalsOf(double step)
{
    if (!(step > 0))
        return 0;
    int decimals = 0;
    for (double scaled = step; decimals < 9 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled;
         ++decimals)
        scaled *= 10;
    return decimals;
}

AxisRange roundRange(double low, double high, double leastSpan)
{
    if (!std::isfinite(low) || !std::isfinite(high) || high < low)
        return {0, leastSpan > 0 ? leastSpan : 1};
    const double missing = std::max(0.0, leastSpan - (high - low));
    low -= missing / 2;
    high += missing / 2;
    const double step = roundStep(std::max(high - low, 1e-12) * 1.05, 6);
    // Noise around a round number does not ask for a whole step more.
    constexpr double slack = 0.04;
    return {std::floor(low / step + slack) * step, std::ceil(high / step - slack) * step};
}

AxisScale axisScale(const QString& name, const QString& unit, double low, double high, int most)
{
    if (!(high > low)) {
        const double middle = std::isfinite(low) && std::isfinite(high) ? (low + high) / 2 : 0.5;
        const double half = middle != 0 ? std::abs(middle) / 10 : 0.5;
        low = middle - half;
        high = middle + half;
    }
    AxisScale scale;
    scale.name = name;
    const ShownUnit shown = shownUnit(unit, std::max(std::abs(low), std::abs(high)));
    scale.unit = shown.unit;
    scale.factor = shown.factor;
    // Steps are round in the unit shown, not in the one stored.
    const double step = roundTicks(low * shown.factor, high * shown.factor, most + 1).step;
    const double first = std::floor(low * shown.factor / step + 1e-9);
    const double last = std::ceil(high * shown.factor / step - 1e-9);
    scale.step = step / shown.factor;
    scale.low = first * scale.step;
    scale.high = last * scale.step;
    for (double n = first; n <= last + 0.5; ++n)
        scale.ticks.push_back(n * scale.step);
    return scale;
}

QString AxisScale::title() const
{
    if (unit.isEmpty())
        return QCoreApplication::translate("gripscope::AxisScale", "%1 (as printed)").arg(name);
    return u"%1 (%2)"_s.arg(name, unit);
}

QString AxisScale::tickText(double value) const
{
    return AxisTicks{{}, step * factor}.label(value * factor);
}

QString AxisScale::valueText(double value) const
{
    const QString number = QLocale().toString(value * factor, 'g', 4);
    return unit.isEmpty() ? number : number + QChar::Nbsp + unit;
}

QString AxisScale::numberText(double value) const
{
    return QLocale().toString(value * factor, 'g', 3);
}

namespace {

constexpr double minute = 60'000, hour = 60 * minute, day = 24 * hour, month = 30.4 * day,
                 year = 365.25 * day;

QDateTime local(double at_ms)
{
    return QDateTime::fromMSecsSinceEpoch(qint64(at_ms));
}

std::vector<TimeTick> withinDays(double low, double high, double step)
{
    std::vector<TimeTick> ticks;
    QDateTime start = local(low).date().startOfDay();
    for (double at = double(start.toMSecsSinceEpoch()); at <= high; at += step) {
        if (at < low)
            continue;
        const QDateTime time = local(at);
        const bool midnight = time.time().msecsSinceStartOfDay() == 0;
        ticks.push_back({at, QLocale().toString(time, midnight ? u"yyyy-MM-dd"_s : u"HH:mm"_s)});
    }
    return ticks;
}

std::vector<TimeTick> byDays(double low, double high, int days)
{
    std::vector<TimeTick> ticks;
    // Counted from one fixed day, so that moving along does not change which days are named.
    qint64 julian = local(low).date().toJulianDay();
    julian -= julian % days;
    for (QDate date = QDate::fromJulianDay(julian); double(date.startOfDay().toMSecsSinceEpoch()) <= high;
         date = date.addDays(days))
        if (const auto at = double(date.startOfDay().toMSecsSinceEpoch()); at >= low)
            ticks.push_back({at, QLocale().toString(date, u"yyyy-MM-dd"_s)});
    return ticks;
}

std::vector<TimeTick> byMonths(double low, double high, int months)
{
    std::vector<TimeTick> ticks;
    const QDate first = local(low).date();
    for (QDate date(first.year(), 1, 1); double(date.startOfDay().toMSecsSinceEpoch()) <= high;
         date = date.addMonths(months))
        if (const auto at = double(date.startOfDay().toMSecsSinceEpoch()); at >= low)
            ticks.push_back({at, QLocale().toString(date, months % 12 == 0 ? u"yyyy"_s : u"yyyy-MM"_s)});
    return ticks;
}

} // namespace

std::vector<TimeTick> timeTicks(double low, double high, int most)
{
    if (!(high > low) || most < 1 || !std::isfinite(low) || !std::isfinite(high))
        return {};
    const double least = (high - low) / most;
    constexpr std::array minutes{1, 2, 5, 10, 15, 30, 60, 120, 180, 360, 720};
    for (const int step : minutes)
        if (step * minute >= least)
            return withinDays(low, high, step * minute);
    for (const int days : {1, 2, 7, 14})
        if (days * day >= least)
            return byDays(low, high, days);
    for (const int months : {1, 3, 6, 12})
        if (months * month >= least)
            return byMonths(low, high, months);
    return byMonths(low, high, 12 * int(std::ceil(least / year)));
}

} // namespace gripscope
