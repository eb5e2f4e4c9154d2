// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/plant/plant_history.h"

namespace gripscope {

class Database;

/// All changes of types and squeezes that a library knows, its own and those of the libraries that it has
/// met, without what only followed from them. The same for two libraries that have met.
[[nodiscard]] Expected<PlantHistory> knownHistory(Database& database);

/// By library the newest version of which changes are known.
[[nodiscard]] Expected<std::map<QString, qint64>> seenVersions(Database& database);

} // namespace gripscope
