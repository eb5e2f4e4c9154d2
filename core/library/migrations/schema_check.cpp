// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/schema_check.h"

#include "core/base/words.h"
#include "core/library/migrations/migration.h"
#include "core/library/sql/statement.h"

#include <QByteArray>

#include <map>
#include <mutex>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What each part was made with, byte by byte, by type and name. As text, what is no blank may look like one.
using Parts = std::map<std::pair<QString, QString>, QByteArray>;

QString comparing()
{
    return Words::tr("be compared with what this program makes");
}

Expected<Parts> partsOf(Database& database)
{
    Parts parts;
    Statement query(database, comparing(), database.dialect().partsSql());
    const auto done = query.forEach([&](Statement& row) {
        const QString type = row.takeText();
        const QString name = row.takeText();
        const QString table = row.takeText();
        parts[{type, name}] = table.toUtf8() + ": " + row.takeBytes().simplified();
    });
    if (!done)
        return tl::unexpected(done.error());
    return parts;
}

Expected<Parts> makeExpected()
{
    ASSIGN_OR_RETURN(const auto empty, Database::inMemory());
    RETURN_IF_ERROR(makeTables(*empty));
    return partsOf(*empty);
}

/// On the server itself, whose versions spell the same differently: among the temporary tables of a
/// connection that are gone with its transaction.
Expected<Parts> makeExpected(const QString& place)
{
    ASSIGN_OR_RETURN(const auto connected, Database::open(place));
    RETURN_IF_ERROR(connected->execute(u"BEGIN; SET LOCAL search_path = pg_temp"_s, comparing()));
    RETURN_IF_ERROR(makeTables(*connected));
    auto parts = partsOf(*connected);
    RETURN_IF_ERROR(connected->execute(u"ROLLBACK"_s, comparing()));
    return parts;
}

/// Made once: of a file the same for all, of a server for all its databases.
Expected<Parts> expectedOf(const Database& database)
{
    static std::mutex mutex;
    static std::map<QString, Parts> known;
    const Expected<LibraryLocation> location = LibraryLocation::parse(database.file());
    const bool onServer = location && location->server();
    const QString place =
        onServer ? u"%1:%2"_s.arg(location->server()->host).arg(location->server()->port) : QString();
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(place); found != known.end())
        return found->second;
    ASSIGN_OR_RETURN(Parts made, database.isOnServer() ? makeExpected(database.file()) : makeExpected());
    return known.emplace(place, std::move(made)).first->second;
}

} // namespace

Expected<void> makeTables(Database& database)
{
    QStringList statements{migrationTable()};
    for (const Migration& step : migrations())
        statements += step.statements;
    for (QString& statement : statements)
        statement = database.dialect().ofMigration(statement);
    if (database.isOnServer()) // at once: each would cost a way to the server and back
        return database.execute(statements.join(u";\n"_s), comparing());
    for (const QString& statement : statements)
        RETURN_IF_ERROR(database.execute(statement, comparing()));
    return {};
}

QString inWords(SchemaDifference::What what)
{
    switch (what) {
    case SchemaDifference::What::Missing:
        return Words::tr("is missing");
    case SchemaDifference::What::Different:
        return Words::tr("differs from what this program makes");
    case SchemaDifference::What::Unknown:
        return Words::tr("was made by no version of this program");
    }
    return {};
}

Expected<std::vector<SchemaDifference>> schemaDifferences(Database& database)
{
    ASSIGN_OR_RETURN(const Parts right, expectedOf(database));
    ASSIGN_OR_RETURN(const Parts found, partsOf(database));
    std::vector<SchemaDifference> differences;
    for (const auto& [part, made] : right) {
        const auto there = found.find(part);
        if (there == found.end())
            differences.push_back({SchemaDifference::What::Missing, part.first, part.second});
        else if (there->second != made)
            differences.push_back({SchemaDifference::What::Different, part.first, part.second});
    }
    for (const auto& [part, made] : found)
        if (!right.contains(part))
            differences.push_back({SchemaDifference::What::Unknown, part.first, part.second});
    return differences;
}

} // namespace gripscope
