// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/merge/library_merge.h"

namespace gripscope {

Expected<MergeReport> Library::mergeLibrary(const QString& file, const ChangeNote& note)
{
    RETURN_IF_ERROR(requirePermission(*d->database, Permission::ChangeTypes)); // before it is gone through
    ASSIGN_OR_RETURN(const auto source, openToMerge(file, *d->database));
    return d->writeIf<MergeReport>(Permission::ChangeTypes, Words::tr("merge another library"),
                                   [&] { return gripscope::mergeLibrary(*source, *d->database, note); });
}

Expected<std::vector<StationStanding>> Library::stations() const
{
    return stationsOf(*d->database);
}

Expected<std::vector<PlantConflict>> Library::conflicts() const
{
    return unseenConflicts(*d->database, d->meetings);
}

Expected<void> Library::noteConflictsSeen(const std::vector<PlantConflict>& conflicts, const ChangeNote& note)
{
    return d->writeIf<void>(Permission::ChangeTypes, Words::tr("note that it was seen"),
                            [&] { return noteSeen(*d->database, conflicts, note); });
}

} // namespace gripscope
