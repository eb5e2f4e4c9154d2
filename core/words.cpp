// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/words.h"

#include <QLocale>

namespace gripscope {

QString Words::number(double value, char format, int digits)
{
    return QString::number(value, format, digits).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

} // namespace gripscope
