// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/type_state_table.h"

#include "core/base/words.h"

#include <map>

namespace gripscope::type_state_table {

using namespace Qt::StringLiterals;

namespace {

/// A type takes or keeps a name.
struct NameTaken {
    QString typeId, name, utc;
};

/// In the order in which they were.
Expected<std::vector<NameTaken>> namesTaken(Database& database)
{
    std::vector<NameTaken> taken;
    Statement query(database, Words::tr("read the types"),
                    u"SELECT type_id, name, created_utc FROM type_states WHERE status <> 'gone' "
                    "ORDER BY version, type_id"_s);
    RETURN_IF_ERROR(query.forEach([&](Statement& row) {
        NameTaken one;
        one.typeId = row.takeText();
        one.name = row.takeText();
        one.utc = row.takeText();
        taken.push_back(std::move(one));
    }));
    return taken;
}

/// The type that has each name, or had it last.
std::map<QString, QString> lastOwners(const std::vector<NameTaken>& taken)
{
    std::map<QString, QString> owners;
    for (const NameTaken& one : taken)
        owners[one.name] = one.typeId;
    return owners;
}

/// When this name was the type's.
std::vector<TypeNameSpan> spansOf(const std::vector<NameTaken>& taken, const QString& typeId,
                                  const QString& name)
{
    std::vector<TypeNameSpan> spans;
    QString owner;
    for (const NameTaken& one : taken) {
        if (one.name != name || one.typeId == owner)
            continue;
        if (one.typeId == typeId)
            spans.push_back({name, owner.isEmpty() ? QString() : one.utc, {}});
        else if (owner == typeId)
            spans.back().until = one.utc;
        owner = one.typeId;
    }
    return spans;
}

} // namespace

Expected<void> insert(Database& database, qint64 version, const TypeState& state)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("change the type"),
                  u"INSERT INTO type_states (id, station, created_utc, type_id, version, name, status, "
                  "recipe_version, code, part_limits) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(state.typeId).bind(version);
    row.bind(state.name).bind(toString(state.status)).bind(state.recipeVersion).bind(state.code);
    return row.bind(toText(state.limits)).run();
}

Expected<std::vector<TypeState>> at(Database& database, qint64 version)
{
    std::vector<TypeState> states;
    Statement query(database, Words::tr("read the types"),
                    u"SELECT s.type_id, s.name, s.status, s.recipe_version, s.code, s.part_limits FROM "
                    u"type_states s WHERE "
                    "s.version = (SELECT MAX(w.version) FROM type_states w WHERE w.type_id = s.type_id AND "
                    "w.version <= ?) ORDER BY s.type_id"_s);
    const auto done = query.bind(version).forEach([&](Statement& row) {
        TypeState state;
        state.typeId = row.takeText();
        state.name = row.takeText();
        state.status = typeStatusFromString(row.takeText()).value_or(TypeStatus::Gone);
        state.recipeVersion = int(row.takeInteger());
        state.code = row.takeText();
        state.limits = partLimitsFromText(row.takeText()).value_or(PartLimits());
        states.push_back(std::move(state));
    });
    if (!done)
        return tl::unexpected(done.error());
    return states;
}

Expected<std::vector<TypeNameSpan>> nameSpans(Database& database, const QString& name)
{
    ASSIGN_OR_RETURN(const auto taken, namesTaken(database));
    const auto owners = lastOwners(taken);
    const auto owner = owners.find(name);
    if (owner == owners.end())
        return std::vector<TypeNameSpan>{{name}};
    QStringList names;
    for (const NameTaken& one : taken)
        if (one.typeId == owner->second && !names.contains(one.name))
            names << one.name;
    std::vector<TypeNameSpan> spans;
    for (const QString& own : names)
        for (TypeNameSpan& span : spansOf(taken, owner->second, own))
            spans.push_back(std::move(span));
    return spans;
}

Expected<QStringList> namesToday(Database& database, const QStringList& names)
{
    ASSIGN_OR_RETURN(const auto taken, namesTaken(database));
    const auto owners = lastOwners(taken);
    std::map<QString, QString> today; // of types
    for (const NameTaken& one : taken)
        today[one.typeId] = one.name;
    QStringList called;
    for (const QString& name : names) {
        const auto owner = owners.find(name);
        called << (owner == owners.end() ? name : today.at(owner->second));
    }
    called.removeDuplicates();
    return called;
}

} // namespace gripscope::type_state_table
