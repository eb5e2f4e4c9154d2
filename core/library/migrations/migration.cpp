// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_writer.h"
#include "core/library/sql/statement.h"

#include <QCryptographicHash>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString bringingUpToDate()
{
    return Words::tr("be brought up to date");
}

/// Of a step after the ledger: its own entry at least.
Expected<void> enterNewRows(Database& database)
{
    return continueLedger(database).map([](const std::optional<ChainEnd>&) {});
}

Expected<void> checkApplied(Database& database, const std::vector<Migration>& steps)
{
    QString changed;
    Statement query(database, bringingUpToDate(),
                    u"SELECT version, checksum FROM schema_migrations ORDER BY version"_s);
    auto done = query.forEach([&](Statement& row) {
        const qint64 version = row.takeInteger();
        const QString checksum = row.takeText();
        for (const Migration& step : steps)
            if (step.version == version && step.checksum() != checksum)
                changed = Words::tr(step.name.toUtf8());
    });
    if (done && !changed.isEmpty())
        return failure(
            ErrorCode::StorageOpen,
            {database.file(),
             Words::tr("its tables (\"%1\") were made by another edition of this program").arg(changed)});
    return done;
}

Expected<void> apply(Database& database, const Migration& step)
{
    ASSIGN_OR_RETURN(auto transaction, Transaction::begin(database, bringingUpToDate()));
    database.knownColumns().clear();
    const auto version = schemaVersion(database); // another process may have been quicker
    if (!version)
        return tl::unexpected(version.error());
    if (*version >= step.version)
        return {};
    if (database.isOnServer()) // an index over millions of rows may take as long as it does
        RETURN_IF_ERROR(database.execute(u"SET LOCAL statement_timeout = 0"_s, bringingUpToDate()));
    QStringList statements = step.statements;
    if (*version == 0)
        statements.prepend(migrationTable());
    for (const QString& statement : std::as_const(statements))
        RETURN_IF_ERROR(database.execute(database.dialect().ofMigration(statement), bringingUpToDate()));
    const RowStamp stamp = RowStamp::now();
    Statement entry(database, bringingUpToDate(),
                    u"INSERT INTO schema_migrations VALUES (?, ?, ?, ?, ?, ?)"_s);
    entry.bind(step.version).bind(step.name).bind(step.checksum());
    entry.bind(QStringLiteral(GRIPSCOPE_VERSION)).bind(stamp.station).bind(stamp.utc);
    RETURN_IF_ERROR(entry.run());
    if (step.afterwards)
        RETURN_IF_ERROR(step.afterwards(database));
    return transaction->commit();
}

} // namespace

QString Migration::checksum() const
{
    const QByteArray text = statements.join(u";\n"_s).toUtf8();
    return QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex());
}

QStringList statementsOf(const QString& script)
{
    QStringList statements;
    QString current;
    for (const QString& line : script.split(u'\n')) {
        const QString text = line.trimmed();
        if (text.isEmpty() || text.startsWith("--"_L1))
            continue;
        current += (current.isEmpty() ? u""_s : u"\n"_s) + text;
        if (current.endsWith(u';')) {
            current.chop(1);
            statements.append(current);
            current.clear();
        }
    }
    return statements;
}

const std::vector<Migration>& migrations()
{
    const auto step = [](int version, const char* name, const char* script,
                         std::function<Expected<void>(Database&)> afterwards = {}) {
        return Migration{version, QString::fromUtf8(name), statementsOf(QString::fromUtf8(script)),
                         std::move(afterwards)};
    };
    static const std::vector<Migration> steps = {
        step(1, QT_TRANSLATE_NOOP("Words", "types, squeezes and inspections"), migrationScript1),
        step(2, QT_TRANSLATE_NOOP("Words", "what is known of a gripper's channels"), migrationScript2),
        step(3, QT_TRANSLATE_NOOP("Words", "the noise of a gripper's force channel"), migrationScript3),
        step(4, QT_TRANSLATE_NOOP("Words", "versions of the library, and parts"), migrationScript4),
        step(5, QT_TRANSLATE_NOOP("Words", "calibrations of sensors"), migrationScript5),
        step(6, QT_TRANSLATE_NOOP("Words", "pictures of parts, and enrolments under way"), migrationScript6),
        step(7, QT_TRANSLATE_NOOP("Words", "checks on a reference object"), migrationScript7),
        step(8, QT_TRANSLATE_NOOP("Words", "what the history shows of squeezes"), migrationScript8),
        step(9, QT_TRANSLATE_NOOP("Words", "batches, and codes of types"), migrationScript9),
        step(10, QT_TRANSLATE_NOOP("Words", "people and the audit trail"), migrationScript10),
        step(11, QT_TRANSLATE_NOOP("Words", "policies"), migrationScript11),
        step(12, QT_TRANSLATE_NOOP("Words", "the ledger of all rows, and their order"), migrationScript12,
             enterFoundRows),
        step(13, QT_TRANSLATE_NOOP("Words", "what was in force when a part was judged"), migrationScript13,
             enterNewRows),
        step(14, QT_TRANSLATE_NOOP("Words", "what is not approved is not judged"), migrationScript14,
             approveFoundTypes),
        step(15, QT_TRANSLATE_NOOP("Words", "inspections that do not count, and part numbers"),
             migrationScript15, enterNewRows),
        step(16, QT_TRANSLATE_NOOP("Words", "tallies of inspections, and recordings stored once"),
             migrationScript16, enterNewRows),
        step(17, QT_TRANSLATE_NOOP("Words", "certificates of calibrations"), migrationScript17, enterNewRows),
        step(18, QT_TRANSLATE_NOOP("Words", "what the history is found by"), migrationScript18, enterNewRows),
        step(19, QT_TRANSLATE_NOOP("Words", "the clock that a squeeze was recorded by"), migrationScript19,
             enterNewRows),
        step(20, QT_TRANSLATE_NOOP("Words", "how the force of a squeeze goes"), migrationScript20,
             enterNewRows),
        step(21, QT_TRANSLATE_NOOP("Words", "the friction of a gripper itself"), migrationScript21,
             enterNewRows),
        step(22, QT_TRANSLATE_NOOP("Words", "what squeezes determine besides m, b and k"), migrationScript22,
             enterNewRows),
        step(23, QT_TRANSLATE_NOOP("Words", "levels of a force that somebody has"), migrationScript23,
             enterNewRows),
        step(24, QT_TRANSLATE_NOOP("Words", "tolerance limits of parts"), partLimitsScript, enterNewRows),
        step(25, QT_TRANSLATE_NOOP("Words", "studies of the gripper"), studiesScript, enterNewRows),
        step(26, QT_TRANSLATE_NOOP("Words", "what control charts are drawn from"), processChartsScript,
             enterNewRows),
        step(27, QT_TRANSLATE_NOOP("Words", "adjustments of grippers"), adjustmentsScript, enterNewRows),
        step(28, QT_TRANSLATE_NOOP("Words", "what stations have of each other"), stationsScript,
             enterNewRows),
        step(29, QT_TRANSLATE_NOOP("Words", "what the changes of a plant are found by"), plantChangesScript,
             enterNewRows),
    };
    return steps;
}

QString migrationTable()
{
    return u"CREATE TABLE schema_migrations (version INTEGER PRIMARY KEY, name TEXT NOT NULL, "
           "checksum TEXT NOT NULL, program TEXT NOT NULL, station TEXT NOT NULL, "
           "applied_utc TEXT NOT NULL)"_s;
}

Expected<int> schemaVersion(Database& database)
{
    ASSIGN_OR_RETURN(const auto tables, database.tables());
    if (tables.isEmpty())
        return 0;
    if (!tables.contains("schema_migrations"_L1))
        return failure(ErrorCode::StorageOpen,
                       {database.file(), Words::tr("it is the database of another program")});
    int version = 0;
    Statement query(database, bringingUpToDate(), u"SELECT MAX(version) FROM schema_migrations"_s);
    auto done = query.forEach([&](Statement& row) { version = int(row.takeInteger()); });
    if (!done)
        return tl::unexpected(done.error());
    return version;
}

Expected<void> migrate(Database& database, const std::vector<Migration>& steps)
{
    ASSIGN_OR_RETURN(const auto version, schemaVersion(database));
    const int newest = steps.back().version;
    if (version > newest)
        return failure(ErrorCode::StorageNewer,
                       {database.file(), QString::number(version), QString::number(newest)});
    RETURN_IF_ERROR(database.prepareForWriting());
    for (const Migration& step : steps) {
        if (step.version <= version)
            continue;
        RETURN_IF_ERROR(apply(database, step));
    }
    return checkApplied(database, steps);
}

} // namespace gripscope
