// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/session/enroll/enroll_session.h"

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

/// The same with the draft of that name, where there is one and it is asked for: the squeeze that waits for a
/// decision, and the picture, which is the type's where the draft has none.
struct StoredEnrollment {
    StoredType stored;
    std::optional<EnrollmentDraft> draft;
    std::optional<DraftSqueeze> pending;
    std::optional<PartPicture> picture;
};
[[nodiscard]] Expected<StoredEnrollment> findStoredEnrollment(Library& library, const QString& name,
                                                              bool withDraft);

/// An accepted squeeze.
struct SqueezeToStore {
    QString name; ///< of the type
    Recipe recipe;
    NewGrasp grasp;
    QString graspId = {};                      ///< not empty: the library has it, and it counts again
    std::optional<EnrollmentDraft> draft = {}; ///< as it is afterwards
};
struct StoredSqueeze {
    TypeRecord type;
    QString graspId;
};
/// All at once: the type when it is new, with its picture, the squeeze, the draft. UnitsDiffer when the type
/// has units that the squeeze's cannot be converted to.
[[nodiscard]] Expected<StoredSqueeze> storeSqueeze(Library& library, const SqueezeToStore& squeeze);

/// A squeeze of an enrolment that is being resumed.
[[nodiscard]] EnrollSqueeze enrolledSqueeze(const GraspRecord& grasp);

/// Why a measurement may not be enrolled; empty when it may.
[[nodiscard]] QString whyNotEnrolled(const Identification& identification,
                                     const std::optional<DeterminedQuantities>& determined);

/// Whether both hold the same numbers to the last digit: one recording, taken twice. No two squeezes do.
[[nodiscard]] bool sameMeasurement(const EnrollSqueeze& one, const EnrollSqueeze& other);

/// What is wrong with a recipe: Usage, or LimitExceeded when it asks for more than its own crush limit.
[[nodiscard]] std::optional<Error> recipeError(const Recipe& recipe);

} // namespace gripscope
