// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/type_tables.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/recipe_columns.h"
#include "core/library/tables/serial.h"

namespace gripscope::type_table {

using namespace Qt::StringLiterals;

namespace {

/// By the version of the library that brought it, not by a clock; keys of one version go by when they were
/// made.
const auto selectPlaces =
    u"SELECT o.id AS type_id, ROW_NUMBER() OVER (ORDER BY (SELECT MIN(w.version) FROM type_states w WHERE "
    "w.type_id = o.id), o.id) - 1 AS place FROM types o"_s;

const auto selectTypes =
    u"SELECT t.id, s.name, t.created_utc, "_s + recipeColumns(u"v."_s) +
    u", v.force_unit, v.position_unit, "
    "(SELECT COUNT(*) FROM grasps g LEFT JOIN placements p ON p.grasp_id = g.id AND p.version = "
    "(SELECT MAX(q.version) FROM placements q WHERE q.grasp_id = g.id) "
    "WHERE (g.type_id = t.id OR g.id IN (SELECT r.grasp_id FROM placements r WHERE r.type_id = t.id)) "
    "AND COALESCE(p.type_id, g.type_id) = t.id AND COALESCE(p.accepted, 1) = 1), "
    "s.status, s.recipe_version, s.code, s.part_limits, c.place "
    "FROM types t JOIN type_states s ON s.type_id = t.id AND s.version = "
    "(SELECT MAX(w.version) FROM type_states w WHERE w.type_id = t.id) "
    "JOIN type_versions v ON v.type_id = t.id AND v.version = s.recipe_version JOIN ("_s +
    selectPlaces + u") c ON c.type_id = t.id "_s;

TypeRecord takeType(Statement& row)
{
    TypeRecord type;
    type.id = row.takeText();
    type.name = row.takeText();
    type.created = row.takeUtc();
    type.recipe = takeRecipe(row);
    type.forceUnit = row.takeText();
    type.positionUnit = row.takeText();
    type.squeezes = int(row.takeInteger());
    type.status = typeStatusFromString(row.takeText()).value_or(TypeStatus::Gone);
    type.approved = type.status == TypeStatus::Approved;
    type.recipeVersion = int(row.takeInteger());
    type.code = row.takeText();
    type.limits = partLimitsFromText(row.takeText()).value_or(PartLimits());
    type.place = int(row.takeInteger());
    return type;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& name)
{
    // The column is unique, and an earlier type may have had this name: its own is in type_states.
    Statement row(database, Words::tr("add the type"),
                  u"INSERT INTO types (id, station, created_utc, name) SELECT ?, ?, ?, "
                  "CASE WHEN EXISTS (SELECT 1 FROM types o WHERE o.name = ?) THEN ? ELSE ? END"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(name);
    return row.bind(name + u' ' + stamp.id).bind(name).run();
}

Expected<QHash<QString, int>> places(Database& database)
{
    QHash<QString, int> places;
    Statement query(database, Words::tr("read the types"), selectPlaces);
    auto done = query.forEach([&](Statement& row) {
        const QString id = row.takeText();
        places.insert(id, int(row.takeInteger()));
    });
    if (!done)
        return tl::unexpected(done.error());
    return places;
}

Expected<std::vector<TypeRecord>> all(Database& database)
{
    Statement query(database, Words::tr("read the types"),
                    selectTypes + u"WHERE s.status <> 'gone' ORDER BY s.name"_s);
    return allRows(query, takeType);
}

Expected<std::optional<TypeRecord>> findByName(Database& database, const QString& name)
{
    Statement query(database, Words::tr("read the types"),
                    selectTypes + u"WHERE s.name = ? AND s.status <> 'gone'"_s);
    return firstRow(query.bind(name), takeType);
}

Expected<std::optional<TypeRecord>> findById(Database& database, const QString& id)
{
    Statement query(database, Words::tr("read the types"), selectTypes + u"WHERE t.id = ?"_s);
    return firstRow(query.bind(id), takeType);
}

} // namespace gripscope::type_table

namespace gripscope::type_version_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId, const Recipe& recipe,
                      const QString& forceUnit, const QString& positionUnit)
{
    Statement row(database, Words::tr("store the recipe"),
                  u"INSERT INTO type_versions (id, station, created_utc, type_id, version, "_s +
                      recipeColumns() +
                      u", force_unit, position_unit) VALUES (?, ?, ?, ?, "
                      "(SELECT COALESCE(MAX(version), 0) + 1 FROM type_versions WHERE type_id = ?), "_s +
                      recipePlaces() + u", ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(typeId).bind(typeId);
    bindRecipe(row, recipe);
    return row.bind(forceUnit).bind(positionUnit).run();
}

Expected<int> newest(Database& database, const QString& typeId)
{
    int version = 0;
    Statement query(database, Words::tr("read the recipe"),
                    u"SELECT COALESCE(MAX(version), 0) FROM type_versions WHERE type_id = ?"_s);
    const auto done = query.bind(typeId).forEach([&](Statement& row) { version = int(row.takeInteger()); });
    if (!done)
        return tl::unexpected(done.error());
    return version;
}

} // namespace gripscope::type_version_table

namespace gripscope::type_picture_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                      const QString& pictureId, const QString& operatorName)
{
    Statement row(database, Words::tr("store the type's picture"),
                  u"INSERT INTO type_pictures (id, station, created_utc, type_id, picture_id, operator_name, "
                  "serial) VALUES (?, ?, ?, ?, ?, ?, "_s +
                      nextSerial(u"type_pictures"_s) + u')');
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(typeId);
    return row.bindOrNull(pictureId).bind(operatorName).run();
}

Expected<QString> inForce(Database& database, const QString& typeId)
{
    QString pictureId;
    Statement query(database, Words::tr("read the type's picture"),
                    u"SELECT picture_id FROM type_pictures WHERE type_id = ? ORDER BY "_s + newestFirst +
                        u" LIMIT 1"_s);
    auto done = query.bind(typeId).forEach([&](Statement& row) { pictureId = row.takeText(); });
    if (!done)
        return tl::unexpected(done.error());
    return pictureId;
}

} // namespace gripscope::type_picture_table
