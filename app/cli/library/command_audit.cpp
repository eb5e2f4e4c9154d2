// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/type_library.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "core/library/audit/audit_trail.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QJsonObject toJson(const AuditEntry& entry)
{
    const QJsonObject details = QJsonDocument::fromJson(entry.details.toUtf8()).object();
    return {{u"number"_s, entry.number},   {u"time"_s, entry.utc},
            {u"station"_s, entry.station}, {u"person"_s, entry.person},
            {u"role"_s, entry.role},       {u"action"_s, entry.action},
            {u"subject"_s, entry.subject}, {u"reason"_s, entry.reason},
            {u"details"_s, details},       {u"previous_hash"_s, entry.previousHash},
            {u"hash"_s, entry.hash}};
}

QJsonObject toJson(const AuditVerification& found)
{
    const bool whole = found.whole();
    return {{u"whole"_s, whole},
            {u"entries"_s, found.head.entries},
            {u"head"_s, found.head.hash},
            {u"fault"_s, whole ? QJsonValue() : QJsonValue(toString(found.fault))},
            {u"at"_s, whole ? QJsonValue() : QJsonValue(found.at)},
            {u"witnessed"_s, found.witnessed},
            {u"witness"_s, found.witness},
            {u"message"_s, inWords(found)}};
}

QString lineOf(const AuditEntry& entry)
{
    QStringList parts{QString::number(entry.number),
                      entry.utc,
                      entry.role.isEmpty() ? entry.person : u"%1 (%2)"_s.arg(entry.person, entry.role),
                      entry.action,
                      entry.subject,
                      entry.reason,
                      detailsInWords(entry)};
    parts.removeAll(QString());
    return parts.join(u"  "_s);
}

Expected<void> list(Library& library, const AuditFilter& filter, bool json)
{
    ASSIGN_OR_RETURN(const auto total, library.auditTrail().count(filter));
    ASSIGN_OR_RETURN(const auto entries, library.auditTrail().entries(filter));
    QJsonArray documents;
    for (const AuditEntry& entry : entries)
        if (json)
            documents.append(toJson(entry));
        else
            print(lineOf(entry));
    if (json)
        printJson({{u"total"_s, total}, {u"entries"_s, documents}});
    else if (entries.empty())
        print(u"No entries."_s);
    return {};
}

/// Verifies and tells; whether it is whole.
Expected<bool> verify(Library& library, bool json)
{
    ASSIGN_OR_RETURN(const auto found, library.auditTrail().verify());
    if (json)
        printJson(toJson(found));
    else
        print(inWords(found));
    return found.whole();
}

} // namespace

int runAudit(const QStringList& arguments)
{
    CommandLine line(
        u"audit"_s, u"Lists who did what, when and why, newest first; or verifies that no entry was changed, "
                    "removed or put in (exit code 5 when one was)."_s);
    line.flag(u"verify"_s, u"Read every entry and check the chain."_s);
    line.option(u"text"_s, u"TEXT"_s, u"Only entries with this person, type, reason or station."_s);
    line.option(u"limit"_s, u"N"_s, u"At most so many."_s, u"50"_s);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    AuditFilter filter;
    filter.text = line.text(u"text"_s);
    filter.limit = line.integer(u"limit"_s, 1, 2'000'000'000);
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    bool whole = true;
    const int exit = withLibrary(line, [&](Library& library) -> Expected<void> {
        if (!line.isSet(u"verify"_s))
            return list(library, filter, json);
        return verify(library, json).map([&](bool fine) { whole = fine; });
    });
    return whole ? exit : static_cast<int>(Exit::Storage);
}

} // namespace gripscope::cli
