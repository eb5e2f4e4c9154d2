// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/bounded_number.h"

#include "core/base/printable.h"

#include <QLocale>

namespace gripscope::cli {

double boundedNumber(CommandLine& line, const QString& name, double least, double most)
{
    bool ok = false;
    const double value = QLocale::c().toDouble(line.text(name), &ok);
    if (ok && value >= least && value <= most)
        return value;
    line.reject(QStringLiteral("--%1 is \"%2\"; a number from %3 to %4 was expected.")
                    .arg(name, printable(line.text(name), longestQuote), QString::number(least),
                         QString::number(most)));
    return least;
}

} // namespace gripscope::cli
