// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/plant/plant_state.h"

namespace gripscope {

class Database;

/// Makes a version of the library in which types and squeezes are as `state` says; rows are put in for what
/// differs from it. Returns the version.
[[nodiscard]] Expected<qint64> settle(Database& database, const PlantState& state, const QString& file,
                                      const ChangeNote& note);

} // namespace gripscope
