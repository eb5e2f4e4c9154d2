// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/tables/approval_check.h"
#include "core/library/tables/change_table.h"
#include "core/library/tables/grasp_table.h"
#include "core/library/tables/person_table.h"
#include "core/library/tables/placement_table.h"
#include "core/library/tables/type_state_table.h"
#include "core/library/tables/type_tables.h"
#include "core/library/tables/type_writer.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<void> requireReason(const ChangeNote& note)
{
    if (note.reason.trimmed().isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("Say why: the reason is kept with the change.")});
    return {};
}

LibraryChange changeOf(ChangeKind kind, const TypeRecord& type, const ChangeNote& note)
{
    LibraryChange change;
    change.kind = kind;
    change.type = type.name;
    change.operatorName = note.operatorName;
    change.reason = note.reason.trimmed();
    return change;
}

/// Records the change and, from it on, the state.
Expected<void> changeState(Database& database, const LibraryChange& change, const TypeState& state)
{
    ASSIGN_OR_RETURN(const auto version, change_table::insert(database, change));
    return type_state_table::insert(database, version, state);
}

Expected<QStringList> acceptedSqueezes(Database& database, const QString& typeId)
{
    ASSIGN_OR_RETURN(const auto grasps, grasp_table::ofType(database, typeId));
    QStringList ids;
    for (const GraspRecord& grasp : grasps)
        if (grasp.accepted)
            ids.append(grasp.id);
    return ids;
}

Expected<void> placeAll(Database& database, qint64 version, const QStringList& graspIds,
                        const QString& typeId)
{
    for (const QString& graspId : graspIds)
        RETURN_IF_ERROR(placement_table::insert(database, version, graspId, {typeId, true}));
    return {};
}

Expected<TypeRecord> rename(Database& database, const QString& typeId, const QString& name,
                            const ChangeNote& note)
{
    const auto type = requireType(database, typeId);
    if (!type)
        return type;
    auto done = requireReason(note);
    if (done)
        done = requireFreeName(database, name);
    if (!done)
        return tl::unexpected(done.error());
    LibraryChange change = changeOf(ChangeKind::Rename, *type, note);
    change.other = name;
    TypeState state = stateOf(*type);
    state.name = name;
    if (done = changeState(database, change, state); !done)
        return tl::unexpected(done.error());
    return requireType(database, typeId);
}

Expected<TypeRecord> merge(Database& database, const QString& typeId, const QString& intoId,
                           const ChangeNote& note)
{
    const auto type = requireType(database, typeId);
    if (!type)
        return type;
    const auto into = requireTypeInUse(database, intoId);
    if (!into)
        return into;
    if (typeId == intoId)
        return failure(ErrorCode::Usage, {Words::tr("A type cannot be merged into itself.")});
    RETURN_IF_ERROR(requireReason(note));
    ASSIGN_OR_RETURN(const auto moved, acceptedSqueezes(database, typeId));
    LibraryChange change = changeOf(ChangeKind::Merge, *type, note);
    change.other = into->name;
    change.squeezes = int(moved.size());
    ASSIGN_OR_RETURN(const auto version, change_table::insert(database, change));
    TypeState gone = stateOf(*type);
    gone.status = TypeStatus::Gone;
    auto done = placeAll(database, version, moved, intoId);
    if (done)
        done = type_state_table::insert(database, version, gone);
    if (done)
        done = type_state_table::insert(database, version, unapproved(*into));
    if (!done)
        return tl::unexpected(done.error());
    return requireType(database, intoId);
}

/// The squeezes that are to leave, each once; Usage unless all are accepted ones of the type and some stay.
Expected<QStringList> leavingSqueezes(Database& database, const TypeRecord& type, QStringList graspIds)
{
    const auto own = acceptedSqueezes(database, type.id);
    if (!own)
        return own;
    graspIds.removeDuplicates();
    const bool allOwn =
        std::all_of(graspIds.cbegin(), graspIds.cend(), [&](const QString& id) { return own->contains(id); });
    if (!allOwn)
        return failure(ErrorCode::Usage,
                       {Words::tr("Only accepted squeezes of %1 can be taken out of it.").arg(type.name)});
    if (graspIds.isEmpty() || graspIds.size() == own->size())
        return failure(ErrorCode::Usage,
                       {Words::tr("Some squeezes of %1 must go into the new type, and some must "
                                  "stay; to change the name of all, rename it.")
                            .arg(type.name)});
    return graspIds;
}

Expected<TypeRecord> split(Database& database, const QString& typeId, const QStringList& graspIds,
                           const QString& name, const ChangeNote& note)
{
    const auto type = requireType(database, typeId);
    if (!type)
        return type;
    RETURN_IF_ERROR(requireReason(note));
    ASSIGN_OR_RETURN(const auto moved, leavingSqueezes(database, *type, graspIds));
    LibraryChange change = changeOf(ChangeKind::Split, *type, note);
    change.other = name;
    change.squeezes = int(moved.size());
    ASSIGN_OR_RETURN(const auto version, change_table::insert(database, change));
    const auto added =
        createType(database, {name, type->recipe, type->forceUnit, type->positionUnit, type->limits},
                   TypeStatus::Enrolled, version);
    if (!added)
        return added;
    auto done = placeAll(database, version, moved, added->id);
    if (done)
        done = type_state_table::insert(database, version, unapproved(*type));
    if (!done)
        return tl::unexpected(done.error());
    return requireType(database, added->id);
}

/// A scanned code must name one type, also when a retired one is put back into use.
Expected<void> requireFreeCode(Database& database, const QString& typeId, const QString& code)
{
    ASSIGN_OR_RETURN(const auto types, type_table::all(database));
    for (const TypeRecord& other : types)
        if (other.id != typeId && other.code == code && !code.isEmpty())
            return failure(ErrorCode::Usage,
                           {Words::tr("%1 has the code %2 already.").arg(other.name, code)});
    return {};
}

Expected<TypeRecord> setCode(Database& database, const QString& typeId, const QString& code,
                             const ChangeNote& note)
{
    const auto type = requireType(database, typeId);
    if (!type || type->code == code)
        return type;
    auto done = requireReason(note);
    if (done)
        done = requireFreeCode(database, typeId, code);
    if (!done)
        return tl::unexpected(done.error());
    LibraryChange change = changeOf(ChangeKind::Code, *type, note);
    change.other = code;
    TypeState state = stateOf(*type);
    state.code = code;
    if (done = changeState(database, change, state); !done)
        return tl::unexpected(done.error());
    return requireType(database, typeId);
}

/// What parts are held to is approved as their squeezes are; where there are no people, whoever sets it
/// stands for it.
Expected<TypeRecord> setLimits(Database& database, const QString& typeId, const PartLimits& wanted,
                               const ChangeNote& note)
{
    const PartLimits limits = wanted.isEmpty() ? PartLimits() : wanted; // a rule for nothing is none
    const auto type = requireType(database, typeId);
    if (!type || type->limits == limits)
        return type;
    RETURN_IF_ERROR(requireReason(note));
    if (std::optional<Error> problem = limits.isEmpty() ? std::nullopt : limits.validate())
        return tl::unexpected(*problem);
    ASSIGN_OR_RETURN(const auto people, person_table::isAnybodyThere(database));
    LibraryChange change = changeOf(ChangeKind::Limits, *type, note);
    change.other = toText(limits);
    TypeState state = people ? unapproved(*type) : stateOf(*type);
    state.limits = limits;
    RETURN_IF_ERROR(changeState(database, change, state));
    return requireType(database, typeId);
}

/// To a status that the type must not have already.
Expected<void> changeStatus(Database& database, const TypeRecord& type, ChangeKind kind, TypeStatus status,
                            const ChangeNote& note)
{
    TypeState state = stateOf(type);
    state.status = status;
    return changeState(database, changeOf(kind, type, note), state);
}

Expected<std::vector<TypeRecord>> typesThat(Database& database, bool areRetired)
{
    auto types = type_table::all(database);
    if (types)
        types->erase(std::remove_if(types->begin(), types->end(),
                                    [areRetired](const TypeRecord& type) {
                                        return (type.status == TypeStatus::Retired) != areRetired;
                                    }),
                     types->end());
    return types;
}

} // namespace

Expected<TypeRecord> Library::addType(const QString& name, const Recipe& recipe, const QString& forceUnit,
                                      const QString& positionUnit, const QString& operatorName)
{
    return d->write<TypeRecord>(Words::tr("add the type"), [&]() -> Expected<TypeRecord> {
        LibraryChange change;
        change.kind = ChangeKind::NewType;
        change.type = name;
        change.operatorName = operatorName;
        ASSIGN_OR_RETURN(const auto version, change_table::insert(*d->database, change));
        return createType(*d->database, {name, recipe, forceUnit, positionUnit}, TypeStatus::Enrolled,
                          version);
    });
}

Expected<TypeRecord> Library::reviseType(const QString& typeId, const Recipe& recipe, const ChangeNote& note)
{
    return d->writeIf<TypeRecord>(
        Permission::ChangeLimits, Words::tr("store the recipe"), [&]() -> Expected<TypeRecord> {
            const auto type = requireType(*d->database, typeId);
            if (!type || type->recipe == recipe)
                return type;
            ASSIGN_OR_RETURN(const auto number, appendRecipe(*d->database, *type, recipe));
            TypeState state = stateOf(*type);
            state.recipeVersion = number;
            RETURN_IF_ERROR(changeState(*d->database, changeOf(ChangeKind::Recipe, *type, note), state));
            return requireType(*d->database, typeId);
        });
}

Expected<void> Library::approveType(const QString& typeId, const QString& operatorName, const QString& reason)
{
    return d->writeIf<void>(Permission::ApproveTypes, Words::tr("approve the type"), [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(const auto type, requireTypeInUse(*d->database, typeId));
        RETURN_IF_ERROR(requireApprover(*d->database, type));
        return changeStatus(*d->database, type, ChangeKind::Approve, TypeStatus::Approved,
                            {operatorName, reason});
    });
}

Expected<std::vector<TypeRecord>> Library::types() const
{
    return typesThat(*d->database, false);
}

Expected<std::vector<TypeRecord>> Library::retiredTypes() const
{
    return typesThat(*d->database, true);
}

Expected<std::optional<TypeRecord>> Library::findType(const QString& name) const
{
    return type_table::findByName(*d->database, name);
}

Expected<TypeRecord> Library::renameType(const QString& typeId, const QString& name, const ChangeNote& note)
{
    return d->writeIf<TypeRecord>(Permission::ChangeTypes, Words::tr("rename the type"),
                                  [&] { return rename(*d->database, typeId, name.trimmed(), note); });
}

Expected<TypeRecord> Library::mergeTypes(const QString& typeId, const QString& intoId, const ChangeNote& note)
{
    return d->writeIf<TypeRecord>(Permission::ChangeTypes, Words::tr("merge the types"),
                                  [&] { return merge(*d->database, typeId, intoId, note); });
}

Expected<TypeRecord> Library::splitType(const QString& typeId, const QStringList& graspIds,
                                        const QString& name, const ChangeNote& note)
{
    return d->writeIf<TypeRecord>(Permission::ChangeTypes, Words::tr("split the type"), [&] {
        return split(*d->database, typeId, graspIds, name.trimmed(), note);
    });
}

Expected<void> Library::retireType(const QString& typeId, const ChangeNote& note)
{
    return d->writeIf<void>(Permission::ChangeTypes, Words::tr("retire the type"), [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(const auto type, requireTypeInUse(*d->database, typeId));
        RETURN_IF_ERROR(requireReason(note));
        return changeStatus(*d->database, type, ChangeKind::Retire, TypeStatus::Retired, note);
    });
}

Expected<void> Library::reinstateType(const QString& typeId, const ChangeNote& note)
{
    return d->writeIf<void>(
        Permission::ChangeTypes, Words::tr("put the type back into use"), [&]() -> Expected<void> {
            ASSIGN_OR_RETURN(const auto type, requireType(*d->database, typeId));
            RETURN_IF_ERROR(requireReason(note));
            if (type.status != TypeStatus::Retired)
                return failure(ErrorCode::Usage, {Words::tr("%1 is in use already.").arg(type.name)});
            return changeStatus(*d->database, type, ChangeKind::Reinstate, TypeStatus::Enrolled, note);
        });
}

Expected<TypeRecord> Library::setTypeCode(const QString& typeId, const QString& code, const ChangeNote& note)
{
    return d->writeIf<TypeRecord>(Permission::ChangeTypes, Words::tr("store the code"),
                                  [&] { return setCode(*d->database, typeId, code.trimmed(), note); });
}

Expected<TypeRecord> Library::setTypeLimits(const QString& typeId, const PartLimits& limits,
                                            const ChangeNote& note)
{
    return d->writeIf<TypeRecord>(Permission::ChangeTypes, Words::tr("store the tolerance limits"),
                                  [&] { return setLimits(*d->database, typeId, limits, note); });
}

} // namespace gripscope
