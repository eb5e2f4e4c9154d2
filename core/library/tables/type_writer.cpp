// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/type_writer.h"

#include "core/base/words.h"
#include "core/library/tables/change_table.h"
#include "core/library/tables/type_state_table.h"
#include "core/library/tables/type_tables.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<void> checkRecipe(const Recipe& recipe)
{
    for (double value :
         {recipe.peak_N, recipe.bias_N, recipe.bit_s, recipe.seconds, recipe.maxForce_N, recipe.maxTravel_m})
        if (!std::isfinite(value))
            return failure(ErrorCode::Usage, {Words::tr("The recipe holds a number that is not finite.")});
    if (recipe.levels.size() > mostLevels ||
        !std::ranges::all_of(recipe.levels, [](double level) { return std::isfinite(level); }))
        return failure(ErrorCode::Usage,
                       {Words::tr("The levels of the recipe's force are too many, or one is not finite.")});
    return {};
}

} // namespace

TypeState stateOf(const TypeRecord& type)
{
    return {type.id, type.name, type.status, type.recipeVersion, type.squeezes, type.code, type.limits};
}

TypeState unapproved(const TypeRecord& type)
{
    TypeState state = stateOf(type);
    if (state.status == TypeStatus::Approved)
        state.status = TypeStatus::Enrolled;
    return state;
}

Expected<qint64> recordSqueezeChange(Database& database, const TypeRecord& type, LibraryChange change)
{
    change.type = type.name;
    change.squeezes = 1;
    if (type.status == TypeStatus::Approved)
        change.other = QString::fromUtf16(approvalVoid);
    ASSIGN_OR_RETURN(const auto version, change_table::insert(database, change));
    if (type.status == TypeStatus::Approved)
        RETURN_IF_ERROR(type_state_table::insert(database, version, unapproved(type)));
    return version;
}

Expected<void> requireComparableUnits(const QString& force, const QString& position,
                                      const QString& wantedForce, const QString& wantedPosition)
{
    const bool bothSi = siFactor(force, position) && siFactor(wantedForce, wantedPosition);
    if (bothSi || (force == wantedForce && position == wantedPosition))
        return {};
    return failure(ErrorCode::UnitsDiffer, {Words::tr("%1 and %2").arg(force, position),
                                            Words::tr("%1 and %2").arg(wantedForce, wantedPosition)});
}

Expected<TypeRecord> requireType(Database& database, const QString& typeId)
{
    ASSIGN_OR_RETURN(const auto type, type_table::findById(database, typeId));
    if (!type || type->status == TypeStatus::Gone)
        return failure(ErrorCode::NotFound, {Words::tr("type with the key %1").arg(typeId)});
    return *type;
}

Expected<TypeRecord> requireTypeInUse(Database& database, const QString& typeId)
{
    auto type = requireType(database, typeId);
    if (type && type->status == TypeStatus::Retired)
        return failure(ErrorCode::Usage,
                       {Words::tr("%1 is retired. Put it back into use first, or choose another type.")
                            .arg(type->name)});
    return type;
}

Expected<void> requireFreeName(Database& database, const QString& name)
{
    if (name.trimmed().isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("A type needs a name.")});
    ASSIGN_OR_RETURN(const auto other, type_table::findByName(database, name));
    if (!other)
        return {};
    return failure(ErrorCode::Usage,
                   {other->status == TypeStatus::Retired
                        ? Words::tr("There is already a type called %1; it is retired.").arg(name)
                        : Words::tr("There is already a type called %1.").arg(name)});
}

Expected<TypeRecord> createType(Database& database, const NewType& type, TypeStatus status, qint64 version)
{
    RETURN_IF_ERROR(requireFreeName(database, type.name));
    RETURN_IF_ERROR(checkRecipe(type.recipe));
    ASSIGN_OR_RETURN(const auto others, type_table::all(database));
    for (const TypeRecord& other : others) {
        RETURN_IF_ERROR(
            requireComparableUnits(type.forceUnit, type.positionUnit, other.forceUnit, other.positionUnit));
    }
    const RowStamp stamp = RowStamp::now();
    RETURN_IF_ERROR(type_table::insert(database, stamp, type.name));
    RETURN_IF_ERROR(type_version_table::insert(database, RowStamp::now(), stamp.id, type.recipe,
                                               type.forceUnit, type.positionUnit));
    TypeState state;
    state.typeId = stamp.id;
    state.name = type.name;
    state.status = status;
    state.limits = type.limits;
    RETURN_IF_ERROR(type_state_table::insert(database, version, state));
    return requireType(database, stamp.id);
}

Expected<int> appendRecipe(Database& database, const TypeRecord& type, const Recipe& recipe)
{
    RETURN_IF_ERROR(checkRecipe(recipe));
    return type_version_table::insert(database, RowStamp::now(), type.id, recipe, type.forceUnit,
                                      type.positionUnit)
        .and_then([&] { return type_version_table::newest(database, type.id); });
}

} // namespace gripscope
