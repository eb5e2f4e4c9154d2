// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/stream_account.h"

#include <QStringList>

#include <array>
#include <cmath>

namespace gripscope {

namespace {

struct Count {
    QLatin1String name;
    std::uint64_t StreamAccount::*value;
};
const std::array<Count, 6> counts{{{QLatin1String("lost_samples"), &StreamAccount::lostSamples},
                                   {QLatin1String("gaps"), &StreamAccount::gaps},
                                   {QLatin1String("duplicate_reports"), &StreamAccount::duplicateReports},
                                   {QLatin1String("bad_reports"), &StreamAccount::badReports},
                                   {QLatin1String("clock_steps"), &StreamAccount::clockSteps},
                                   {QLatin1String("stalls"), &StreamAccount::stalls}}};
const QLatin1String longestStall("longest_stall_s");
const QLatin1String clockCompared("clock_compared");

struct Rate {
    QLatin1String ppm, uncertainty;
    std::optional<RateDifference> ClockAccount::*value;
};
const std::array<Rate, 2> rates{
    {{QLatin1String("clock_ppm"), QLatin1String("clock_uncertainty_ppm"), &ClockAccount::clock},
     {QLatin1String("sampling_ppm"), QLatin1String("sampling_uncertainty_ppm"), &ClockAccount::sampling}}};

QString field(QLatin1String name, double value)
{
    return QStringLiteral("%1=%2").arg(name).arg(value, 0, 'g', 12);
}

/// A number that is none, and a rate without both of its numbers, say nothing.
ClockAccount clocksFromText(const QMap<QString, QString>& fields)
{
    ClockAccount clocks;
    clocks.compared = fields.value(clockCompared) == QLatin1String("1");
    for (const Rate& rate : rates) {
        bool isRate = false, isUncertainty = false;
        const RateDifference read{fields.value(rate.ppm).toDouble(&isRate),
                                  fields.value(rate.uncertainty).toDouble(&isUncertainty)};
        const bool usable = isRate && isUncertainty && std::isfinite(read.ppm) &&
                            std::isfinite(read.uncertainty_ppm) && read.uncertainty_ppm >= 0;
        if (clocks.compared && usable)
            clocks.*rate.value = read;
    }
    return clocks;
}

} // namespace

QString streamAccountKey()
{
    return QStringLiteral("stream");
}

QString unseenLossesKey()
{
    return QStringLiteral("losses");
}

QString toText(const StreamAccount& account)
{
    QStringList parts;
    for (const Count& count : counts)
        parts << QStringLiteral("%1=%2").arg(count.name).arg(account.*count.value);
    parts << field(longestStall, account.longestStall_s);
    if (account.clocks.compared)
        parts << QStringLiteral("%1=1").arg(clockCompared);
    for (const Rate& rate : rates)
        if (const std::optional<RateDifference>& known = account.clocks.*rate.value;
            known && account.clocks.compared)
            parts << field(rate.ppm, known->ppm) << field(rate.uncertainty, known->uncertainty_ppm);
    return parts.join(QLatin1Char(' '));
}

StreamAccount streamAccountFromText(const QString& text)
{
    QMap<QString, QString> fields;
    for (const QString& part : text.split(QLatin1Char(' '), Qt::SkipEmptyParts))
        fields.insert(part.section(QLatin1Char('='), 0, 0), part.section(QLatin1Char('='), 1));
    StreamAccount account;
    for (const Count& count : counts)
        account.*count.value = fields.value(count.name).toULongLong();
    account.longestStall_s = fields.value(longestStall).toDouble();
    account.clocks = clocksFromText(fields);
    return account;
}

std::optional<StreamAccount> streamAccount(const Recording& recording)
{
    const auto found = recording.provenance.find(streamAccountKey());
    if (found == recording.provenance.end())
        return std::nullopt;
    return streamAccountFromText(found.value());
}

} // namespace gripscope
