// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/ledger/ledger_writer.h"
#include "core/library/migrations/migration.h"
#include "core/library/sql/statement.h"

#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

const char* const migrationScript14 = R"sql(
-- From here on only approved types are recognised. Those that were recognised before without approval stay in force,
-- approved as they were found; not so those whose enrolment is still under way, which are approved at its end.
)sql";

namespace {

struct FoundType {
    QString id, name, code;
    qint64 recipeVersion = 1;
};

QString bringing()
{
    return Words::tr("be brought up to date");
}

/// In use, not approved, with a squeeze that counts.
Expected<std::vector<FoundType>> recognisedTypes(Database& database)
{
    std::vector<FoundType> types;
    Statement query(
        database, bringing(),
        u"SELECT s.type_id, s.name, s.recipe_version, s.code FROM type_states s "
        "WHERE s.status = 'enrolled' AND s.version = "
        "(SELECT MAX(w.version) FROM type_states w WHERE w.type_id = s.type_id) "
        "AND COALESCE((SELECT d.state FROM enrollment_drafts d WHERE d.type_name = s.name "
        "ORDER BY d.serial DESC, d.created_utc DESC, d.id DESC LIMIT 1), '') <> 'open' "
        "AND EXISTS (SELECT 1 FROM grasps g "
        "JOIN estimates e ON e.grasp_id = g.id AND e.rank = 0 AND e.m IS NOT NULL "
        "LEFT JOIN placements p ON p.grasp_id = g.id AND p.version = "
        "(SELECT MAX(q.version) FROM placements q WHERE q.grasp_id = g.id) "
        "WHERE (g.type_id = s.type_id OR g.id IN (SELECT r.grasp_id FROM placements r WHERE r.type_id = "
        "s.type_id)) AND COALESCE(p.type_id, g.type_id) = s.type_id AND COALESCE(p.accepted, 1) = 1) "
        "ORDER BY s.name"_s);
    const auto done = query.forEach([&](Statement& row) {
        FoundType type;
        type.id = row.takeText();
        type.name = row.takeText();
        type.recipeVersion = row.takeInteger();
        type.code = row.takeText();
        types.push_back(std::move(type));
    });
    if (!done)
        return tl::unexpected(done.error());
    return types;
}

Expected<void> approveAsFound(Database& database, const FoundType& type, qint64 version)
{
    const RowStamp change = RowStamp::now();
    Statement changed(database, bringing(),
                      u"INSERT INTO library_changes (id, station, changed_utc, version, kind, type_name, "
                      "other_name, squeezes, operator_name, reason) VALUES (?, ?, ?, ?, 'approve', ?, '', 0, "
                      "'', 'as found: it was recognised before approval decided')"_s);
    changed.bind(change.id).bind(change.station).bind(change.utc).bind(version).bind(type.name);
    RETURN_IF_ERROR(changed.run());
    const RowStamp state = RowStamp::now();
    Statement approved(database, bringing(),
                       u"INSERT INTO type_states (id, station, created_utc, type_id, version, name, status, "
                       "recipe_version, code) VALUES (?, ?, ?, ?, ?, ?, 'approved', ?, ?)"_s);
    approved.bind(state.id).bind(state.station).bind(state.utc).bind(type.id).bind(version);
    return approved.bind(type.name).bind(type.recipeVersion).bind(type.code).run();
}

} // namespace

Expected<void> approveFoundTypes(Database& database)
{
    ASSIGN_OR_RETURN(const std::vector<FoundType> types, recognisedTypes(database));
    qint64 version = 0;
    Statement newest(database, bringing(), u"SELECT COALESCE(MAX(version), 0) FROM library_changes"_s);
    RETURN_IF_ERROR(newest.forEach([&](Statement& row) { version = row.takeInteger(); }));
    for (const FoundType& type : types)
        RETURN_IF_ERROR(approveAsFound(database, type, ++version));
    return continueLedger(database).map([](const auto&) {});
}

} // namespace gripscope
