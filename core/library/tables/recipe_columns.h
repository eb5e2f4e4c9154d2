// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/type_record.h"
#include "core/library/sql/statement.h"

namespace gripscope {

/// The columns of a recipe, wherever one is stored, as the two below take and bind them: name, peak, bias,
/// bit, seconds, largest force, travel, how the force goes, its levels. `table`: what stands before each,
/// such as "v.".
[[nodiscard]] QString recipeColumns(const QString& table = {});
[[nodiscard]] QString recipePlaces(); ///< "?, ?": a place for each
[[nodiscard]] Recipe takeRecipe(Statement& row);
void bindRecipe(Statement& row, const Recipe& recipe);

} // namespace gripscope
