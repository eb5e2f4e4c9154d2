// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/date_text.h"

#include <cstdlib>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString local(const QDateTime& time, const QString& format)
{
    return time.isValid() ? time.toLocalTime().toString(format) : u"–"_s;
}

} // namespace

QString dateText(const QDate& date)
{
    return date.isValid() ? date.toString(dateFormat) : u"–"_s;
}

QString dateText(const QDateTime& time)
{
    return dateText(time.toLocalTime().date());
}

QString timeText(const QDateTime& time)
{
    return local(time, u"yyyy-MM-dd HH:mm"_s);
}

QString zonedTimeText(const QDateTime& time)
{
    if (!time.isValid())
        return timeText(time);
    const int minutes = time.toLocalTime().offsetFromUtc() / 60;
    const auto two = [](int number) { return u"%1"_s.arg(number, 2, 10, QChar(u'0')); };
    return u"%1 UTC%2%3:%4"_s.arg(timeText(time), minutes < 0 ? u"−"_s : u"+"_s, two(std::abs(minutes) / 60),
                                  two(std::abs(minutes) % 60));
}

QString exactTimeText(const QDateTime& time)
{
    return local(time, u"yyyy-MM-dd HH:mm:ss"_s);
}

QString timeThereText(const QDateTime& time)
{
    if (!time.isValid())
        return u"–"_s;
    const int offset_s = time.offsetFromUtc();
    const QString hours = QTime(0, 0).addSecs(std::abs(offset_s)).toString(u"HH:mm"_s);
    return time.toString(u"yyyy-MM-dd HH:mm:ss"_s) + (offset_s < 0 ? u" -"_s : u" +"_s) + hours;
}

} // namespace gripscope
