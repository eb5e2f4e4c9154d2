// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/clock_standing.h"

#include <QStringList>

#include <cmath>
#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// "0.000006523 seconds slow of NTP time", with a sign by the word.
std::optional<double> secondsIn(const QString& text)
{
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    bool isNumber = false;
    const double value = words.value(0).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(value) || words.value(1) != "seconds"_L1)
        return {};
    return words.value(2) == "slow"_L1 ? -value : value;
}

} // namespace

std::optional<ClockStanding> clockStandingFrom(const QString& printed)
{
    std::map<QString, QString> fields;
    for (const QString& line : printed.split(u'\n'))
        fields[line.section(u':', 0, 0).trimmed()] = line.section(u':', 1).trimmed();
    const std::optional<double> offset = secondsIn(fields[u"System time"_s]);
    const std::optional<double> delay = secondsIn(fields[u"Root delay"_s]);
    const std::optional<double> dispersion = secondsIn(fields[u"Root dispersion"_s]);
    const QString leap = fields[u"Leap status"_s];
    if (!offset || !delay || !dispersion || leap.isEmpty() || leap == "Not synchronised"_L1)
        return {};
    return ClockStanding{*offset, std::abs(*dispersion) + std::abs(*delay) / 2};
}

} // namespace gripscope
