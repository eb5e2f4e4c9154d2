// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/plant/plant_conflict.h"

#include <map>
#include <memory>
#include <vector>

namespace gripscope {

class Database;
struct ReadMeetings;

/// What a merge has done.
struct MergeReport {
    QString file;
    std::map<QString, qint64> taken;      ///< rows by table
    qint64 forTheRecord = 0;              ///< what is of its station alone, such as its audit trail
    qint64 alreadyThere = 0;              ///< rows of the other's tables
    qint64 links = 0;                     ///< of ledgers, carried along
    qint64 version = 0;                   ///< of this library; 0: types and squeezes are as before
    std::vector<PlantConflict> conflicts; ///< that no supervisor has seen
    [[nodiscard]] qint64 rows() const;
};
/// "1,204 rows were taken..."
[[nodiscard]] QString inWords(const MergeReport& report);

/// Brings all that `source` has and `target` has not into it, within the open write transaction. Twice is the
/// same as once. StorageOpen: a copy of this library, or of one that both know, which was gone on with.
/// UnitsDiffer: its types cannot be compared with those that are there.
[[nodiscard]] Expected<MergeReport> mergeLibrary(Database& source, Database& target, const ChangeNote& note);

/// Another library, verified and open to be read alone. StorageOpen where it is not whole, of an earlier
/// program (open it once with this one), or `target` itself; StorageNewer.
[[nodiscard]] Expected<std::unique_ptr<Database>> openToMerge(const QString& file, const Database& target);

/// What of a station is in a library.
struct StationStanding {
    QString station;
    qint64 inspections = 0;
    QString newestUtc; ///< of these; empty: none
    bool isHere = false;
};
[[nodiscard]] Expected<std::vector<StationStanding>> stationsOf(Database& database);

/// What stations decided apart, and nobody has seen here.
[[nodiscard]] Expected<std::vector<PlantConflict>> unseenConflicts(Database& database, ReadMeetings& read);
/// Within a write transaction: somebody has seen them.
[[nodiscard]] Expected<void> noteSeen(Database& database, const std::vector<PlantConflict>& conflicts,
                                      const ChangeNote& note);

} // namespace gripscope
