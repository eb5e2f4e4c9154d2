// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/settlement.h"

#include "core/base/words.h"
#include "core/library/sql/statement.h"
#include "core/library/tables/change_table.h"
#include "core/library/tables/placement_table.h"
#include "core/library/tables/type_state_table.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<std::map<QString, int>> recipeNumbers(Database& database)
{
    std::map<QString, int> numbers;
    Statement query(database, Words::tr("read the recipes"), u"SELECT id, version FROM type_versions"_s);
    const auto done = query.forEach([&](Statement& row) {
        const QString id = row.takeText();
        numbers[id] = static_cast<int>(row.takeInteger());
    });
    if (!done)
        return tl::unexpected(done.error());
    return numbers;
}

Expected<void> settleTypes(Database& database, const PlantState& state, qint64 version)
{
    ASSIGN_OR_RETURN(const auto recipes, recipeNumbers(database));
    ASSIGN_OR_RETURN(const std::vector<TypeState> now, type_state_table::at(database, version));
    for (const TypeState& before : now) {
        const auto type = state.types.find(before.typeId);
        if (type == state.types.end())
            continue;
        TypeState wanted = before;
        wanted.name = type->second.name;
        wanted.status = type->second.status;
        if (const auto recipe = recipes.find(type->second.recipe); recipe != recipes.end())
            wanted.recipeVersion = recipe->second;
        wanted.code = type->second.code;
        wanted.limits = partLimitsFromText(type->second.limits).value_or(PartLimits());
        if (wanted.name != before.name || wanted.status != before.status || wanted.code != before.code ||
            wanted.recipeVersion != before.recipeVersion || !(wanted.limits == before.limits))
            RETURN_IF_ERROR(type_state_table::insert(database, version, wanted));
    }
    return {};
}

Expected<void> settleSqueezes(Database& database, const PlantState& state, qint64 version)
{
    ASSIGN_OR_RETURN(const auto now, placement_table::at(database, version));
    for (const auto& [squeeze, before] : now) {
        const auto place = state.squeezes.find(squeeze);
        if (place == state.squeezes.end())
            continue;
        const Placement wanted{place->second.typeId, place->second.accepted};
        if (!(wanted == before))
            RETURN_IF_ERROR(placement_table::insert(database, version, squeeze, wanted));
    }
    return {};
}

} // namespace

Expected<qint64> settle(Database& database, const PlantState& state, const QString& file,
                        const ChangeNote& note)
{
    LibraryChange change;
    change.kind = ChangeKind::Meeting;
    change.other = file;
    change.operatorName = note.operatorName;
    change.reason = note.reason;
    ASSIGN_OR_RETURN(const qint64 version, change_table::insertUntold(database, change));
    RETURN_IF_ERROR(settleTypes(database, state, version));
    RETURN_IF_ERROR(settleSqueezes(database, state, version));
    return version;
}

} // namespace gripscope
