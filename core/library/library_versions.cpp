// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/tables/approval_check.h"
#include "core/library/tables/change_table.h"
#include "core/library/tables/placement_table.h"
#include "core/library/tables/type_state_table.h"
#include "core/library/tables/type_tables.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<qint64> requireVersion(Database& database, qint64 version)
{
    const auto newest = change_table::newestVersion(database);
    if (newest && (version < 0 || version > *newest))
        return failure(
            ErrorCode::Usage,
            {Words::tr("The library has no version %1; its newest is %2.").arg(version).arg(*newest)});
    return newest;
}

const TypeState* find(const std::vector<TypeState>& states, const QString& typeId)
{
    const auto place =
        std::lower_bound(states.begin(), states.end(), typeId,
                         [](const TypeState& state, const QString& id) { return state.typeId < id; });
    return place != states.end() && place->typeId == typeId ? &*place : nullptr;
}

bool isSame(const TypeState& one, const TypeState& other)
{
    return one.name == other.name && one.status == other.status && one.recipeVersion == other.recipeVersion &&
           one.code == other.code && one.limits == other.limits;
}

/// What types and squeezes were like at two versions.
struct Difference {
    std::vector<TypeState> types; ///< those that differ, as they were at the earlier version
    std::map<QString, Placement> placements;
};

Expected<Difference> differenceFrom(Database& database, qint64 earlier, qint64 now)
{
    const auto oldTypes = type_state_table::at(database, earlier);
    const auto newTypes = type_state_table::at(database, now);
    const auto oldPlacements = placement_table::at(database, earlier);
    const auto newPlacements = placement_table::at(database, now);
    if (!oldTypes || !newTypes)
        return tl::unexpected((oldTypes ? newTypes : oldTypes).error());
    if (!oldPlacements || !newPlacements)
        return tl::unexpected((oldPlacements ? newPlacements : oldPlacements).error());
    Difference difference;
    for (const TypeState& state : *newTypes) {
        TypeState wanted = state;
        wanted.status = TypeStatus::Gone; // unless it was there
        if (const TypeState* old = find(*oldTypes, state.typeId))
            wanted = *old;
        if (!isSame(wanted, state))
            difference.types.push_back(wanted);
    }
    for (const auto& [graspId, placement] : *newPlacements)
        if (const auto old = oldPlacements->find(graspId);
            old != oldPlacements->end() && !(old->second == placement))
            difference.placements.insert(*old);
    return difference;
}

/// A version that is put back approves what was approved in it, so that it asks for another person where
/// approving does. The squeezes are those of that version already.
Expected<void> requireApproverOf(Database& database, const std::vector<TypeState>& restored)
{
    for (const TypeState& state : restored) {
        if (state.status != TypeStatus::Approved)
            continue;
        ASSIGN_OR_RETURN(const auto type, type_table::findById(database, state.typeId));
        if (type)
            RETURN_IF_ERROR(requireApprover(database, *type, Permission::ChangeTypes));
    }
    return {};
}

Expected<qint64> restore(Database& database, qint64 version, const ChangeNote& note)
{
    const auto newest = requireVersion(database, version);
    if (!newest)
        return newest;
    if (note.reason.trimmed().isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("Say why: the reason is kept with the change.")});
    ASSIGN_OR_RETURN(const auto difference, differenceFrom(database, version, *newest));
    if (difference.types.empty() && difference.placements.empty())
        return failure(ErrorCode::Usage,
                       {Words::tr("Types and squeezes are as they were at version %1.").arg(version)});
    LibraryChange change;
    change.kind = ChangeKind::Restore;
    change.other = QString::number(version);
    change.squeezes = int(difference.placements.size());
    change.operatorName = note.operatorName;
    change.reason = note.reason.trimmed();
    const auto made = change_table::insert(database, change);
    if (!made)
        return made;
    for (const TypeState& state : difference.types)
        RETURN_IF_ERROR(type_state_table::insert(database, *made, state));
    for (const auto& [graspId, placement] : difference.placements)
        RETURN_IF_ERROR(placement_table::insert(database, *made, graspId, placement));
    RETURN_IF_ERROR(requireApproverOf(database, difference.types));
    return made;
}

Expected<LibraryState> stateOfLibrary(Database& database, qint64 version)
{
    RETURN_IF_ERROR(requireVersion(database, version));
    ASSIGN_OR_RETURN(auto types, type_state_table::at(database, version));
    ASSIGN_OR_RETURN(const auto placements, placement_table::at(database, version));
    std::map<QString, int> squeezes;
    for (const auto& [graspId, placement] : placements)
        squeezes[placement.typeId] += placement.accepted;
    LibraryState state{version, {}};
    for (TypeState& type : types) {
        type.squeezes = squeezes[type.typeId];
        if (type.status != TypeStatus::Gone)
            state.types.push_back(std::move(type));
    }
    std::sort(state.types.begin(), state.types.end(),
              [](const TypeState& one, const TypeState& other) { return one.name < other.name; });
    return state;
}

} // namespace

Expected<qint64> Library::version() const
{
    return change_table::newestVersion(*d->database);
}

Expected<std::vector<LibraryChange>> Library::changes(int limit, int offset) const
{
    return change_table::page(*d->database, limit, offset);
}

Expected<LibraryState> Library::stateAt(qint64 version) const
{
    return stateOfLibrary(*d->database, version);
}

Expected<qint64> Library::restoreVersion(qint64 version, const ChangeNote& note)
{
    return d->writeIf<qint64>(Permission::ChangeTypes, Words::tr("restore version %1").arg(version),
                              [&] { return restore(*d->database, version, note); });
}

} // namespace gripscope
