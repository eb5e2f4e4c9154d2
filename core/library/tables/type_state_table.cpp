// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/type_state_table.h"

#include "core/base/words.h"

namespace gripscope::type_state_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, qint64 version, const TypeState& state)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("change the type"),
                  u"INSERT INTO type_states (id, station, created_utc, type_id, version, name, status, "
                  "recipe_version, code) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(state.typeId).bind(version);
    return row.bind(state.name).bind(toString(state.status)).bind(state.recipeVersion).bind(state.code).run();
}

Expected<std::vector<TypeState>> at(Database& database, qint64 version)
{
    std::vector<TypeState> states;
    Statement query(database, Words::tr("read the types"),
                    u"SELECT s.type_id, s.name, s.status, s.recipe_version, s.code FROM type_states s WHERE "
                    "s.version = (SELECT MAX(w.version) FROM type_states w WHERE w.type_id = s.type_id AND "
                    "w.version <= ?) ORDER BY s.type_id"_s);
    const auto done = query.bind(version).forEach([&](Statement& row) {
        TypeState state;
        state.typeId = row.takeText();
        state.name = row.takeText();
        state.status = typeStatusFromString(row.takeText()).value_or(TypeStatus::Gone);
        state.recipeVersion = int(row.takeInteger());
        state.code = row.takeText();
        states.push_back(std::move(state));
    });
    if (!done)
        return tl::unexpected(done.error());
    return states;
}

} // namespace gripscope::type_state_table
