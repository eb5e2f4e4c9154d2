// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/outside_change.h"
#include "app/cli/line/bounded_number.h"
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "core/people/audit_entry.h"
#include "devices/factory/gripper_factory.h"
#include "devices/replay/capture_folder.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

constexpr double largestLimit_MB = 1e9; // a petabyte

QJsonObject partJson(const CaptureFolder::Part& part)
{
    return {{u"name"_qs, part.name},
            {u"bytes"_qs, part.bytes},
            {u"closed"_qs, part.closed()},
            {u"sha256"_qs, part.closed() ? QJsonValue(part.hash) : QJsonValue::Null},
            {u"squeezes"_qs, part.squeezes ? QJsonValue(*part.squeezes) : QJsonValue::Null}};
}

QString partText(const CaptureFolder::Part& part)
{
    const QString state = part.closed() ? u"%1 squeezes"_qs.arg(part.squeezes.value_or(0)) : u"not closed"_qs;
    return u"%1%2 MB  %3"_qs.arg(part.name, -44)
        .arg(1e-6 * static_cast<double>(part.bytes), 8, 'f', 2)
        .arg(state);
}

int listParts(const CaptureFolder& folder, bool json)
{
    QJsonArray documents;
    qint64 total = 0;
    for (const CaptureFolder::Part& part : folder.parts()) {
        total += part.bytes;
        documents.append(partJson(part));
        if (!json)
            print(partText(part));
    }
    if (json)
        printJson({{u"folder"_qs, folder.path()}, {u"bytes"_qs, total}, {u"captures"_qs, documents}});
    else
        print(u"%1 captures, %2 MB, in %3"_qs.arg(documents.size())
                  .arg(1e-6 * static_cast<double>(total), 0, 'f', 2)
                  .arg(folder.path()));
    return 0;
}

int verifyParts(const CaptureFolder& folder, bool json)
{
    static const QStringList conditions{u"whole"_qs, u"changed"_qs, u"not_closed"_qs, u"unreadable"_qs};
    using Condition = CaptureFolder::Condition;
    ExitCode exit;
    QJsonArray documents;
    for (const CaptureFolder::Part& part : folder.parts()) {
        const CaptureFolder::Checked checked = folder.check(part);
        if (checked.condition == Condition::Changed || checked.condition == Condition::Unreadable)
            exit.add(Exit::BadInput);
        QJsonObject document = partJson(part);
        document[u"condition"_qs] = conditions[static_cast<int>(checked.condition)];
        document[u"message"_qs] = checked.words;
        documents.append(document);
        if (!json)
            print(u"%1%2"_qs.arg(part.name, -44).arg(checked.words));
    }
    if (json)
        printJson({{u"folder"_qs, folder.path()}, {u"captures"_qs, documents}});
    else if (documents.isEmpty())
        print(u"No captures in %1."_qs.arg(folder.path()));
    return exit.value();
}

/// Removing is asked about, and told to the library, only where something would go.
Expected<bool> mayPrune(const CommandLine& line, const CaptureFolder& folder, qint64 limit)
{
    qint64 total = 0;
    for (const CaptureFolder::Part& part : folder.parts())
        total += part.bytes;
    if (total <= limit)
        return true;
    if (!line.isSet(u"yes"_qs) &&
        !confirmed(u"Remove kept sessions from %1 until %2 of %3 MB are left?"_qs.arg(folder.path())
                       .arg(1e-6 * static_cast<double>(limit), 0, 'f', 0)
                       .arg(1e-6 * static_cast<double>(total), 0, 'f', 0)))
        return false;
    RETURN_IF_ERROR(tellOutsideChange(line, QString::fromUtf16(audit_action::capturesPruned), folder.path(),
                                      {{u"bytes_before"_qs, total}, {u"bytes_left_at_most"_qs, limit}}));
    return true;
}

int pruneParts(const CommandLine& line, const CaptureFolder& folder, qint64 limit, bool json)
{
    const Expected<bool> may = mayPrune(line, folder, limit);
    if (!may)
        return fail(may.error(), json);
    if (!*may) {
        message(u"Nothing was removed."_qs);
        return 0;
    }
    const CaptureFolder::Pruned pruned = folder.prune(limit);
    QJsonArray documents;
    for (const CaptureFolder::Part& part : pruned.removed) {
        documents.append(partJson(part));
        if (!json)
            print(u"removed %1"_qs.arg(partText(part)));
    }
    if (pruned.problem)
        return fail(*pruned.problem, json);
    if (json)
        printJson({{u"folder"_qs, folder.path()}, {u"removed"_qs, documents}});
    else
        print(u"%1 captures removed from %2"_qs.arg(documents.size()).arg(folder.path()));
    return 0;
}

} // namespace

int runCaptures(const QStringList& arguments)
{
    CommandLine line(u"captures"_qs,
                     u"Kept sessions, raw reports and all: list shows them, verify reads them and checks "
                     u"their hashes, prune "
                     "removes the oldest until the rest is below --limit, those without a squeeze first."_qs,
                     u"list|verify|prune"_qs);
    line.option(u"folder"_qs, u"FOLDER"_qs, u"Where they are; the user's own without it."_qs);
    line.flag(u"yes"_qs, u"Prune without asking on the terminal."_qs);
    addOutsideChangeOptions(line);
    line.option(u"limit"_qs, u"MEGABYTES"_qs, u"What prune leaves at most."_qs,
                QString::number(1e-6 * static_cast<double>(CaptureLimits{}.totalBytes)));
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const double limit = boundedNumber(line, u"limit"_qs, 0, largestLimit_MB);
    const QString action = line.files().value(0);
    if (line.files().size() != 1 || !QStringList{u"list"_qs, u"verify"_qs, u"prune"_qs}.contains(action))
        line.reject(u"Say one of list, verify and prune."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    const QString named = line.text(u"folder"_qs);
    const CaptureFolder folder(named.isEmpty() ? CaptureFolder::defaultPath() : named);
    if (action == u"list")
        return listParts(folder, json);
    if (action == u"verify")
        return verifyParts(folder, json);
    return pruneParts(line, folder, static_cast<qint64>(limit * 1e6), json);
}

} // namespace gripscope::cli
