// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/plant/plant_state.h"
#include "core/library/sql/table_rows.h"

#include <map>
#include <memory>
#include <vector>

namespace gripscope {

class Database;

/// What a plant has in common, as a server's library has it at one moment, and a station's has not: types
/// with their recipes, enrolled squeezes and pictures, calibrations, references, control limits,
/// adjustments and the people of the server's own library. Read once, so that the station's write transaction
/// waits for no network.
struct ServerTypes {
    std::shared_ptr<Database> rows;            ///< in memory, as they are there
    std::map<QString, std::vector<Cell>> keys; ///< of those that are new, by table
    QString server, place;                     ///< libraryId(), and where it is
    std::map<QString, qint64> seen;            ///< by library the newest version that the server knows
    PlantState state;                          ///< in force there: types and squeezes
    [[nodiscard]] bool anyNew() const { return !keys.empty(); }
};

/// A text that is the same as long as none of it can have changed; cheap to ask for.
[[nodiscard]] Expected<QString> marksOf(Database& server);

[[nodiscard]] Expected<ServerTypes> readServerTypes(Database& server, Database& station);

/// What came of it.
struct FetchedTypes {
    qint64 rows = 0;
    qint64 version = 0;  ///< of the station's library; 0: types are as they were
    bool isLate = false; ///< the station has changed types meanwhile: nothing was done; deliver, then again
};

/// Puts them into the station's library, whose types and squeezes are then as at the server. Within its open
/// write transaction. `delivered`: the version of the station's library up to which the server had its
/// changes before it was read.
[[nodiscard]] Expected<FetchedTypes> takeServerTypes(const ServerTypes& types, Database& station,
                                                     qint64 delivered);

/// Puts people of a server's library into a station's, where roles are in force from then on: each as they
/// are at the server, whatever the station has made of them before; within the station's open transaction,
/// with an entry of the audit trail each. Who is in the station's library alone stays as they are: a name
/// that one of them has comes as "Ada (plant)". At least one active supervisor is left; where what the
/// station changed itself would leave none, all people of the server are as there again. `there`: all rows of
/// the server's people; `news`: the keys of those that the station has not. Returns how many were put in.
[[nodiscard]] Expected<qint64> takeServerPeople(Database& there, const std::vector<Cell>& news,
                                                Database& station, const QString& place);

} // namespace gripscope
