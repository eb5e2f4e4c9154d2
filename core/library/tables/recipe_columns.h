// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/type_record.h"
#include "core/library/sql/statement.h"

namespace gripscope {

/// The seven columns of a recipe, wherever one is stored: name, peak, bias, bit, seconds, largest force,
/// travel.
[[nodiscard]] Recipe takeRecipe(Statement& row);
void bindRecipe(Statement& row, const Recipe& recipe);

} // namespace gripscope
