// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/research/paper_reproduction.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QStringList scalingLines(const QString& name, const QJsonObject& scaling)
{
    QStringList lines{u"Table 1, scaling %1: inertia %2, adjusted Rand index %3"_qs.arg(
        name, QString::number(scaling[u"inertia"_qs].toDouble(), 'g', 10),
        QString::number(scaling[u"adjusted_rand_index"_qs].toDouble(), 'g', 6))};
    lines << u"  trial    A    B    C    D"_qs;
    const QJsonArray table = scaling[u"table1"_qs].toArray();
    for (qsizetype trial = 0; trial < table.size(); ++trial) {
        QString row = u"  %1"_qs.arg(trial + 1, 5);
        for (const QJsonValue& cluster : table[trial].toArray())
            row += QString::number(cluster.toInt()).rightJustified(5);
        lines << row;
    }
    return lines;
}

QString text(const QJsonObject& document)
{
    QStringList lines{u"The paper's 40 squeezes of 4 cans, grouped by k-means (K = 4), units as printed."_qs};
    const QJsonObject scalings = document[u"scalings"_qs].toObject();
    for (const QString& name : {u"none"_qs, u"zscore"_qs, u"log"_qs, u"zlog"_qs})
        if (scalings.contains(name))
            lines << QString() << scalingLines(name, scalings[name].toObject());
    const QJsonObject fit = document[u"best_fit"_qs].toObject();
    lines << QString()
          << u"Best fit: %1 to %2 %. It says nothing about the parameters: noise biases ARX at such fits."_qs
                 .arg(fixed(fit[u"min"_qs].toDouble(), 2), fixed(fit[u"max"_qs].toDouble(), 2))
          << u"Leave one out: %1 of 40 squeezes get their own type back."_qs.arg(
                 document[u"leave_one_out_correct"_qs].toInt());
    return lines.join(u'\n');
}

} // namespace

int runReproducePaper(const QStringList& arguments)
{
    CommandLine line(
        u"reproduce-paper"_qs,
        u"Groups the paper's appendix as its Table 1 does, in each scaling, and leaves one out."_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const QJsonObject document = reproducePaper();
    if (line.isSet(u"json"_qs))
        printJson(document);
    else
        print(text(document));
    return 0;
}

} // namespace gripscope::cli
