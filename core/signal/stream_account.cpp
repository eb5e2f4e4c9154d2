// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/stream_account.h"

#include <QStringList>

#include <array>

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
    parts << QStringLiteral("%1=%2").arg(longestStall).arg(account.longestStall_s, 0, 'g', 12);
    return parts.join(QLatin1Char(' '));
}

StreamAccount streamAccountFromText(const QString& text)
{
    StreamAccount account;
    for (const QString& part : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        const QString name = part.section(QLatin1Char('='), 0, 0);
        const QString value = part.section(QLatin1Char('='), 1);
        for (const Count& count : counts)
            if (name == count.name)
                account.*count.value = value.toULongLong();
        if (name == longestStall)
            account.longestStall_s = value.toDouble();
    }
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
