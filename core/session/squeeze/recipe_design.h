// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/model/motion_terms.h"
#include "core/recognition/types/type_model.h"
#include "core/session/squeeze/squeeze_job.h"
#include "core/signal/excitation/force_levels.h"

#include <optional>
#include <vector>

namespace gripscope {

/// The part that expectations are of: about a full drinks can, its position read with 10 um of noise; rubbing
/// by a fiftieth of the push and release, and yielding by a tenth of its stiffness over a tenth of the
/// squeeze, where a model has such terms.
struct ExpectedPart {
    double m_kg = 0.04, b_Ns_per_m = 43, k_N_per_m = 10'000, noise_m = 1e-5;
    double frictionShare = 0.02, relaxingShare = 0.1, relaxationShare = 0.1;
};

/// What one squeeze can tell at best: for a model, the half-width of a 95 % interval of each of its
/// parameters, in their order, over the parameter's size.
struct ModelExpectation {
    MotionTerms terms;
    std::vector<double> relative; ///< empty: the squeeze does not determine them

    [[nodiscard]] std::optional<double> of(MotionParameter parameter) const;
};

/// Of mass, spring and damper, then with friction, then with a part that goes on yielding
/// (expectedDeviations()). Empty where the gripper cannot squeeze by the recipe, or where its squeeze is too
/// long to be looked through while somebody waits (100,000 samples).
[[nodiscard]] std::vector<ModelExpectation>
expectationOf(const Recipe& recipe, const GripperIdentity& identity, const ExpectedPart& part = {});

/// The two levels of force, within what the recipe allows (preload, push and release, crush limit, length,
/// shortest push), that tell the nearest two of these types apart best (designExcitation()), or that tell
/// most of the only one. `types` in m, b and k in SI; of more than twelve those with the nearest neighbours.
/// None: for an ExpectedPart. In newtons. Errors as designExcitation() has them: the recipe leaves no room,
/// a type swings too fast for the gripper. Takes about a tenth of a second for a second at 2 kHz.
[[nodiscard]] Expected<ForceLevels> designedForce(const Recipe& recipe, const GripperIdentity& identity,
                                                  const TypeModels& types);

} // namespace gripscope
