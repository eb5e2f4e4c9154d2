// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/drift.h"
#include "core/session/inspect/inspected_squeezes.h"

#include <optional>

namespace gripscope {

/// What a look at the drift is of: models and squeezes as the library has them.
struct DriftMaterial {
    TypeModels models;
    InspectedSqueezes inspected;
};
[[nodiscard]] Expected<DriftMaterial> readDriftMaterial(Library& library, const InspectedChoice& choice);

/// What moved, and since when.
struct DriftLook {
    TypeModels models;
    InspectedSqueezes inspected;
    DriftReport report;
    std::optional<ChangePoint> change; ///< of what moved; nothing where nothing has
    Findings since;                    ///< that in words, with inspections and times
};

/// Pure; findDrift(), and findChange() of what it says has moved: of all types by factors or additions where
/// that is the cause, else of the types that moved. Errors: those of findDrift().
[[nodiscard]] Expected<DriftLook> lookForDrift(DriftMaterial material, const DriftOptions& options = {});

} // namespace gripscope
