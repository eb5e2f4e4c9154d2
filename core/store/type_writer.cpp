// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/type_writer.h"

#include "core/signal/units.h"
#include "core/store/type_table.h"
#include "core/store/type_version_table.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<void> checkRecipe(const Recipe& recipe)
{
    for (double value :
         {recipe.peak_N, recipe.bias_N, recipe.bit_s, recipe.seconds, recipe.maxForce_N, recipe.maxTravel_m})
        if (!std::isfinite(value))
            return failure(ErrorCode::Usage, {u"The recipe holds a number that is not finite."_s});
    return {};
}

} // namespace

Expected<void> requireComparableUnits(const QString& force, const QString& position,
                                      const QString& wantedForce, const QString& wantedPosition)
{
    const bool bothSi = siFactor(force, position) && siFactor(wantedForce, wantedPosition);
    if (bothSi || (force == wantedForce && position == wantedPosition))
        return {};
    return failure(ErrorCode::UnitsDiffer,
                   {u"%1 and %2"_s.arg(force, position), u"%1 and %2"_s.arg(wantedForce, wantedPosition)});
}

Expected<TypeRecord> requireType(Database& database, const QString& typeId)
{
    const auto type = type_table::findById(database, typeId);
    if (!type)
        return tl::unexpected(type.error());
    if (!*type)
        return failure(ErrorCode::NotFound, {u"type with the key %1"_s.arg(typeId)});
    return **type;
}

Expected<TypeRecord> createType(Database& database, const NewType& type)
{
    if (type.name.trimmed().isEmpty())
        return failure(ErrorCode::Usage, {u"A type needs a name."_s});
    if (auto fine = checkRecipe(type.recipe); !fine)
        return tl::unexpected(fine.error());
    const auto others = type_table::all(database);
    if (!others)
        return tl::unexpected(others.error());
    for (const TypeRecord& other : *others) {
        if (other.name == type.name)
            return failure(ErrorCode::Usage, {u"There is already a type called %1."_s.arg(type.name)});
        auto comparable =
            requireComparableUnits(type.forceUnit, type.positionUnit, other.forceUnit, other.positionUnit);
        if (!comparable)
            return tl::unexpected(comparable.error());
    }
    const RowStamp stamp = RowStamp::now();
    if (auto done = type_table::insert(database, stamp, type.name); !done)
        return tl::unexpected(done.error());
    auto done = type_version_table::insert(database, RowStamp::now(), stamp.id, type.recipe, type.forceUnit,
                                           type.positionUnit);
    if (!done)
        return tl::unexpected(done.error());
    return requireType(database, stamp.id);
}

Expected<TypeRecord> changeRecipe(Database& database, const QString& typeId, const Recipe& recipe)
{
    const auto type = requireType(database, typeId);
    if (!type)
        return type;
    if (auto fine = checkRecipe(recipe); !fine)
        return tl::unexpected(fine.error());
    if (type->recipe == recipe)
        return type;
    auto done = type_version_table::insert(database, RowStamp::now(), typeId, recipe, type->forceUnit,
                                           type->positionUnit);
    if (!done)
        return tl::unexpected(done.error());
    return requireType(database, typeId);
}

} // namespace gripscope
