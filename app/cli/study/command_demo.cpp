// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/study/demo.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QJsonObject document(std::uint64_t seed, const DemoCounts& counts)
{
    QJsonObject confusion;
    for (auto row = counts.confusion.cbegin(); row != counts.confusion.cend(); ++row) {
        QJsonObject cells;
        for (auto cell = row.value().cbegin(); cell != row.value().cend(); ++cell)
            cells[cell.key()] = cell.value();
        confusion[row.key()] = cells;
    }
    return {{u"seed"_qs, static_cast<qint64>(seed)},
            {u"enrolled"_qs, counts.enrolled},
            {u"tested"_qs, counts.tested},
            {u"correct"_qs, counts.correct},
            {u"wrong_type"_qs, counts.wrongType},
            {u"unknown"_qs, counts.unknown},
            {u"strangers"_qs, counts.strangers},
            {u"strangers_unknown"_qs, counts.strangersUnknown},
            {u"confusion"_qs, confusion}};
}

QString text(std::uint64_t seed, const DemoCounts& counts)
{
    QStringList lines{
        u"Virtual gripper, seed %1: %2 squeezes of 4 types enrolled."_qs.arg(seed).arg(counts.enrolled),
        u"%1 unseen squeezes: %2 right, %3 wrong type, %4 unknown."_qs.arg(counts.tested)
            .arg(counts.correct)
            .arg(counts.wrongType)
            .arg(counts.unknown),
        u"%1 squeezes of a stranger: %2 unknown."_qs.arg(counts.strangers).arg(counts.strangersUnknown)};
    for (auto row = counts.confusion.cbegin(); row != counts.confusion.cend(); ++row) {
        QString line = u"  %1"_qs.arg(row.key(), -10);
        for (auto cell = row.value().cbegin(); cell != row.value().cend(); ++cell)
            line += u"  %1: %2"_qs.arg(cell.key()).arg(cell.value());
        lines << line;
    }
    return lines.join(u'\n');
}

} // namespace

int runDemo(const QStringList& arguments)
{
    CommandLine line(
        u"demo"_qs,
        u"Enrols 4 types with 10 squeezes each on the virtual gripper, then inspects 30 unseen squeezes and "
        "5 of a half-filled can that was never enrolled."_qs);
    line.option(u"seed"_qs, u"N"_qs, u"Seed of all squeezes."_qs, u"1"_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const std::uint64_t seed = line.seed();
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    const Expected<DemoCounts> counts = runDemonstration(seed, message);
    if (!counts)
        return fail(counts.error(), json);
    if (json)
        printJson(document(seed, *counts));
    else
        print(text(seed, *counts));
    return 0;
}

} // namespace gripscope::cli
