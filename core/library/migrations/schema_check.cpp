// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/schema_check.h"

#include "core/base/words.h"
#include "core/library/migrations/migration.h"
#include "core/library/sql/statement.h"

#include <QByteArray>

#include <map>
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
    Statement query(database, comparing(),
                    u"SELECT type, name, tbl_name, CAST(COALESCE(sql, '') AS BLOB) FROM sqlite_master "
                    "WHERE name NOT LIKE 'sqlite!_stat_' ESCAPE '!'"_s);
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
    RETURN_IF_ERROR(empty->execute(migrationTable(), comparing()));
    for (const Migration& step : migrations())
        for (QString statement : step.statements)
            RETURN_IF_ERROR(empty->execute(statement.replace("{blob}"_L1, empty->blobType()), comparing()));
    return partsOf(*empty);
}

const Expected<Parts>& expected()
{
    static const Expected<Parts> parts = makeExpected();
    return parts;
}

} // namespace

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
    if (!expected())
        return tl::unexpected(expected().error());
    ASSIGN_OR_RETURN(const Parts found, partsOf(database));
    std::vector<SchemaDifference> differences;
    const Parts& right = *expected();
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
