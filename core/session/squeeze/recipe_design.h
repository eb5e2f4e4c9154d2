// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/recognition/types/type_model.h"
#include "core/session/squeeze/recipe_expectation.h"
#include "core/signal/excitation/force_levels.h"

namespace gripscope {

/// The two levels of force, within what the recipe allows (preload, push and release, crush limit, length,
/// shortest push), that tell the nearest two of these types apart best (designExcitation()), or that tell
/// most of the only one. `types` in m, b and k in SI; of more than twelve those with the nearest neighbours.
/// None: for an ExpectedPart. In newtons. Errors as designExcitation() has them: the recipe leaves no room,
/// a type swings too fast for the gripper. Takes about a tenth of a second for a second at 2 kHz.
[[nodiscard]] Expected<ForceLevels> designedForce(const Recipe& recipe, const GripperIdentity& identity,
                                                  const TypeModels& types);

} // namespace gripscope
