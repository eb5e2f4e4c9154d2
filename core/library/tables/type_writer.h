// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/inspection_record.h"
#include "core/library/records/type_record.h"
#include "core/library/sql/database.h"

namespace gripscope {

/// What addType() is asked for.
struct NewType {
    QString name;
    Recipe recipe;
    QString forceUnit, positionUnit;
    PartLimits limits = {};
};

/// The type as it is.
[[nodiscard]] TypeState stateOf(const TypeRecord& type);
/// With other squeezes in it than those that were approved: it needs approval again.
[[nodiscard]] TypeState unapproved(const TypeRecord& type);

// All inside a write transaction of the caller; errors as in Library.
/// Records a change of the type's squeezes, and that its approval is void with it; the version that this is.
[[nodiscard]] Expected<qint64> recordSqueezeChange(Database& database, const TypeRecord& type,
                                                   LibraryChange change);
[[nodiscard]] Expected<TypeRecord> createType(Database& database, const NewType& type, TypeStatus status,
                                              qint64 version);
/// Appends the recipe to the type's; its number.
[[nodiscard]] Expected<int> appendRecipe(Database& database, const TypeRecord& type, const Recipe& recipe);
/// NotFound: there is no such type, or it is gone.
[[nodiscard]] Expected<TypeRecord> requireType(Database& database, const QString& typeId);
/// The same; Usage when it is retired.
[[nodiscard]] Expected<TypeRecord> requireTypeInUse(Database& database, const QString& typeId);
/// Nothing when no type that is there, retired or not, has this name; Usage when one has, or there is no
/// name.
[[nodiscard]] Expected<void> requireFreeName(Database& database, const QString& name);

/// Nothing when m, b and k in the one pair of channel units can be compared with those in the other: both can
/// be taken to SI, or they are the same. Else UnitsDiffer.
[[nodiscard]] Expected<void> requireComparableUnits(const QString& force, const QString& position,
                                                    const QString& wantedForce,
                                                    const QString& wantedPosition);

} // namespace gripscope
