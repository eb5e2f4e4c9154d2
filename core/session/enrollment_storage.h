// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enroll_session.h"
#include "core/store/library.h"

#include <optional>
#include <vector>

namespace gripscope {

/// A squeeze as the library takes it: first the recommended estimate of the object alone (the empty gripper
/// taken off where there is a baseline), then the others as measured; the whole identification for audit.
/// Without m, b and k (an invalid inspection) the estimates come in the order they were made.
[[nodiscard]] NewGrasp makeGrasp(const Recording& recording, const Identification& identification,
                                 const QString& source, const QString& operatorName);

/// What the library knows of a type by that name, dropped squeezes included. Usage when it is retired.
struct StoredType {
    std::optional<TypeRecord> type;
    std::vector<GraspRecord> grasps;
};
[[nodiscard]] Expected<StoredType> findStoredType(Library& library, const QString& name);

/// Adds the squeeze, and before it the type when it is new. UnitsDiffer when the type has units that the
/// squeeze's cannot be converted to.
struct StoredSqueeze {
    TypeRecord type;
    QString graspId;
};
[[nodiscard]] Expected<StoredSqueeze> storeSqueeze(Library& library, const QString& name,
                                                   const Recipe& recipe, NewGrasp grasp);

/// A squeeze of an enrolment that is being resumed.
[[nodiscard]] EnrollSqueeze enrolledSqueeze(const GraspRecord& grasp);

/// Why a measurement may not be enrolled; empty when it may.
[[nodiscard]] QString whyNotEnrolled(const Identification& identification);

/// What is wrong with a recipe: Usage, or LimitExceeded when it asks for more than its own crush limit.
[[nodiscard]] std::optional<Error> recipeError(const Recipe& recipe);

} // namespace gripscope
