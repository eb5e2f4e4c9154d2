// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_ticks.h"

#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

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
        ticks.push_back({at, QLocale().toString(time, midnight ? u"MM-dd"_s : u"HH:mm"_s)});
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
