// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/plant/plant_history.h"

#include <vector>

namespace gripscope {

class Database;

/// The meetings of a library as far as they were read: they are only ever added to, and are most of what
/// there is to read. To be emptied where the transaction in which it was read is not committed.
struct ReadMeetings {
    std::vector<PlantMeeting> meetings;
    qint64 own = 0, ofOthers = 0; ///< the last row of each
};

/// All changes of types and squeezes that a library knows, its own and those of the libraries that it has
/// met, without what only followed from them. The same for two libraries that have met.
[[nodiscard]] Expected<PlantHistory> knownHistory(Database& database, ReadMeetings& read);

/// By library the newest version of which changes are known.
[[nodiscard]] Expected<std::map<QString, qint64>> seenVersions(Database& database);

} // namespace gripscope
