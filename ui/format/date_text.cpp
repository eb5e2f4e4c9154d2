// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/date_text.h"

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

QString exactTimeText(const QDateTime& time)
{
    return local(time, u"yyyy-MM-dd HH:mm:ss"_s);
}

QString shortTimeText(const QDateTime& time)
{
    const bool thisYear = time.toLocalTime().date().year() == QDate::currentDate().year();
    return thisYear ? local(time, u"MM-dd HH:mm"_s) : timeText(time);
}

} // namespace gripscope
