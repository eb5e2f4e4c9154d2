// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/squeeze_record.h"
#include "core/library/records/type_record.h"
#include "core/recognition/types/type_model.h"

#include <optional>

namespace gripscope {

/// A stored squeeze as recognition takes it, under the name of the type it belongs to: in SI where the units
/// are known, else in the units it has. Parts of types that were merged stay apart. Nothing where it
/// determined nothing.
[[nodiscard]] std::optional<TypeSqueeze> typeSqueeze(const GraspRecord& grasp);

} // namespace gripscope
