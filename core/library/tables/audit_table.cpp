// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/audit_table.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"

#include <QJsonDocument>

#include <algorithm>

namespace gripscope::audit_table {

using namespace Qt::StringLiterals;

namespace {

QString readingTrail()
{
    return Words::tr("read its audit trail");
}
const auto auditColumns =
    u"SELECT number, created_utc, station, person, role, action, subject, reason, details, "
    "previous_hash, hash FROM audit_entries"_s;

AuditEntry takeAuditEntry(Statement& row)
{
    AuditEntry entry;
    entry.number = row.takeInteger();
    for (QString* text : {&entry.utc, &entry.station, &entry.person, &entry.role, &entry.action,
                          &entry.subject, &entry.reason, &entry.details, &entry.previousHash, &entry.hash})
        *text = row.takeText();
    return entry;
}

ClockStep takeClockStep(Statement& row)
{
    ClockStep step;
    step.station = row.takeText();
    const QJsonObject details = QJsonDocument::fromJson(row.takeText().toUtf8()).object();
    step.from = QDateTime::fromString(details[u"from"].toString(), Qt::ISODateWithMs);
    step.to = row.takeUtc();
    const auto number = [&details](QStringView key) {
        return details.contains(key) ? std::optional(details[key].toInteger()) : std::nullopt;
    };
    step.lastInspection = number(u"last_inspection");
    step.lastVersion = number(u"last_version");
    return step;
}

struct NewestEntry {
    AuditHead head{0, firstPreviousHash()};
    QString station;
    QDateTime made;
};

Expected<NewestEntry> newest(Database& database)
{
    NewestEntry entry;
    Statement query(
        database, readingTrail(),
        u"SELECT number, hash, station, created_utc FROM audit_entries ORDER BY number DESC LIMIT 1"_s);
    const auto done = query.forEach([&](Statement& row) {
        entry.head.entries = row.takeInteger();
        entry.head.hash = row.takeText();
        entry.station = row.takeText();
        entry.made = row.takeUtc();
    });
    if (!done)
        return tl::unexpected(done.error());
    return entry;
}

/// Numbers the entry, puts it behind the last and stores it.
Expected<AuditHead> store(Database& database, const AuditHead& last, AuditEntry entry,
                          const QJsonObject& details)
{
    entry.number = last.entries + 1;
    if (!details.isEmpty())
        entry.details = QString::fromUtf8(QJsonDocument(details).toJson(QJsonDocument::Compact));
    entry.previousHash = last.hash;
    entry.hash = auditHash(entry);
    Statement row(database, Words::tr("continue the audit trail"),
                  u"INSERT INTO audit_entries (number, created_utc, station, person, role, action, subject, "
                  "reason, details, previous_hash, hash) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(entry.number);
    for (const QString* text :
         {&entry.utc, &entry.station, &entry.person, &entry.role, &entry.action, &entry.subject,
          &entry.reason, &entry.details, &entry.previousHash, &entry.hash})
        row.bind(*text);
    RETURN_IF_ERROR(row.run());
    const AuditHead head{entry.number, entry.hash};
    database.setNewAuditHead(head);
    return head;
}

/// When this station made its newest inspection; not valid where none of the last hundred is its own.
Expected<QDateTime> newestInspection(Database& database, const QString& station)
{
    QDateTime newest;
    Statement query(database, readingTrail(),
                    u"SELECT inspected_utc FROM inspections WHERE number > "
                    "(SELECT COALESCE(MAX(number), 0) FROM inspections) - 100 AND station = ? "
                    "ORDER BY number DESC LIMIT 1"_s);
    if (auto done = query.bind(station).forEach([&](Statement& row) { newest = row.takeUtc(); }); !done)
        return tl::unexpected(done.error());
    return newest;
}

/// The time that the station's clock already showed, where it is now behind that and nothing tells of it.
Expected<std::optional<QDateTime>> shownBefore(Database& database, const NewestEntry& last,
                                               const RowStamp& stamp)
{
    constexpr qint64 stepFrom_s = 60; // what a time server corrects is less
    const QDateTime now = QDateTime::fromString(stamp.utc, Qt::ISODateWithMs);
    const auto ahead = [&now](const QDateTime& time) {
        return time.isValid() && now.secsTo(time) >= stepFrom_s;
    };
    std::optional<QDateTime> shown;
    if (last.station == stamp.station && ahead(last.made))
        shown = last.made;
    ASSIGN_OR_RETURN(const QDateTime inspected, newestInspection(database, stamp.station));
    if (!ahead(inspected) || (shown && *shown >= inspected))
        return shown;
    ASSIGN_OR_RETURN(const std::vector<ClockStep> steps, clockSteps(database));
    const bool told = std::any_of(steps.begin(), steps.end(), [&](const ClockStep& step) {
        return step.covers(stamp.station, inspected);
    });
    return told ? shown : std::optional(inspected);
}

/// A clock of this station that was set back is said in the trail itself: its times cannot be taken at their
/// word from there on. Where the trail then ends.
Expected<AuditHead> tellStep(Database& database, const NewestEntry& last, const RowStamp& stamp)
{
    ASSIGN_OR_RETURN(const std::optional<QDateTime> shown, shownBefore(database, last, stamp));
    if (!shown)
        return last.head;
    AuditEntry entry;
    entry.utc = stamp.utc;
    entry.station = entry.subject = stamp.station;
    entry.action = QString::fromUtf16(audit_action::clockBack);
    QJsonObject details{{u"from"_s, utcText(*shown)}, {u"to"_s, stamp.utc}};
    // Which squeezes were there already: their times alone would not tell once the clock has come so far
    // again.
    Statement query(database, readingTrail(),
                    u"SELECT (SELECT COALESCE(MAX(number), 0) FROM inspections), "
                    "(SELECT COALESCE(MAX(library_version), 0) FROM grasps)"_s);
    RETURN_IF_ERROR(query.forEach([&](Statement& row) {
        details.insert(u"last_inspection"_s, row.takeInteger());
        details.insert(u"last_version"_s, row.takeInteger());
    }));
    return store(database, last.head, entry, details);
}

/// Who it was: by whose consent, who is signed in, or the name that was typed.
void sign(AuditEntry& entry, QJsonObject& details, const NewAuditEntry& told, const Acting& acting)
{
    const std::optional<Authority> by = told.by          ? told.by
                                        : acting.granted ? std::optional(acting.granted->by)
                                                         : acting.signedIn;
    const QString operatorName = acting.signedIn               ? acting.signedIn->name()
                                 : told.operatorName.isEmpty() ? acting.operatorName
                                                               : told.operatorName;
    entry.person = by ? by->name() : operatorName;
    entry.role = by ? toString(by->role()) : QString();
    if (acting.granted && !operatorName.isEmpty() && operatorName != entry.person)
        details.insert(u"operator"_s, operatorName);
}

/// "WHERE" with what to look for in every text that is shown.
QString condition(const AuditFilter& filter)
{
    QStringList terms;
    if (!filter.action.isEmpty())
        terms += u"action LIKE ? ESCAPE '\\'"_s;
    if (!filter.text.trimmed().isEmpty())
        terms +=
            u"LOWER(person || ' ' || subject || ' ' || reason || ' ' || details || ' ' || station) LIKE ? "
            "ESCAPE '\\'"_s;
    return terms.isEmpty() ? QString() : u" WHERE "_s + terms.join(u" AND "_s);
}

QString escaped(QString text)
{
    return text.replace(u'\\', u"\\\\"_s).replace(u'%', u"\\%"_s).replace(u'_', u"\\_"_s);
}

void bindFilter(Statement& query, const AuditFilter& filter)
{
    if (!filter.action.isEmpty())
        query.bind(escaped(filter.action) + u'%');
    if (!filter.text.trimmed().isEmpty())
        query.bind(u'%' + escaped(filter.text.trimmed().toLower()) + u'%');
}

} // namespace

Expected<void> append(Database& database, const NewAuditEntry& told)
{
    const RowStamp stamp = RowStamp::now();
    ASSIGN_OR_RETURN(const NewestEntry newestEntry, newest(database));
    ASSIGN_OR_RETURN(const AuditHead last, tellStep(database, newestEntry, stamp));
    QJsonObject details = told.details;
    AuditEntry entry;
    entry.utc = stamp.utc;
    entry.station = stamp.station;
    sign(entry, details, told, database.acting());
    entry.action = told.action;
    entry.subject = told.subject;
    entry.reason = told.reason;
    RETURN_IF_ERROR(store(database, last, entry, details));
    return {};
}

Expected<void> noteClock(Database& database)
{
    ASSIGN_OR_RETURN(const NewestEntry newestEntry, newest(database));
    return tellStep(database, newestEntry, RowStamp::now()).map([](const AuditHead&) {});
}

Expected<std::vector<ClockStep>> clockSteps(Database& database)
{
    // The action is spelled out: there is an index of just these.
    Statement query(database, readingTrail(),
                    u"SELECT station, details, created_utc FROM audit_entries "
                    "WHERE action = 'clock.back' ORDER BY number"_s);
    return allRows(query, takeClockStep);
}

Expected<std::vector<AuditEntry>> page(Database& database, const AuditFilter& filter)
{
    Statement query(database, readingTrail(),
                    auditColumns + condition(filter) + u" ORDER BY number DESC LIMIT ? OFFSET ?"_s);
    bindFilter(query, filter);
    query.bind(std::max(0, filter.limit)).bind(std::max(0, filter.offset));
    return allRows(query, takeAuditEntry);
}

Expected<qint64> count(Database& database, const AuditFilter& filter)
{
    Statement query(database, readingTrail(), u"SELECT COUNT(*) FROM audit_entries"_s + condition(filter));
    bindFilter(query, filter);
    return numberOf(query);
}

Expected<void> forEach(Database& database, const std::function<void(const AuditEntry&)>& taken)
{
    Statement query(database, readingTrail(), auditColumns + u" ORDER BY number"_s);
    return query.forEach([&](Statement& row) { taken(takeAuditEntry(row)); });
}

Expected<QString> hashOf(Database& database, qint64 number)
{
    QString hash;
    Statement query(database, readingTrail(), u"SELECT hash FROM audit_entries WHERE number = ?"_s);
    if (auto done = query.bind(number).forEach([&](Statement& row) { hash = row.takeText(); }); !done)
        return tl::unexpected(done.error());
    return hash;
}

} // namespace gripscope::audit_table
