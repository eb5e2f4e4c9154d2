// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/values/shift_start.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

QString ShiftStart::text() const
{
    return u"%1 %2"_s.arg(QString::number(after), library);
}

bool ShiftStart::isOf(const QString& library, const QString& text)
{
    const qsizetype space = text.indexOf(u' ');
    return space >= 0 && text.mid(space + 1) == library;
}

qint64 ShiftStart::afterIn(const QString& library, const QString& text)
{
    return isOf(library, text) ? std::max<qint64>(0, text.left(text.indexOf(u' ')).toLongLong()) : 0;
}

} // namespace gripscope
