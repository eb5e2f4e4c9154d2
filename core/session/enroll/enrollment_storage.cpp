// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/enroll/enrollment_storage.h"

#include "core/base/words.h"
#include "core/identification/result/identification_json.h"
#include "core/recognition/verdict/identified_squeeze.h"
#include "core/session/squeeze/comparable_units.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

NewGrasp makeGrasp(const Recording& recording, const Identification& identification, const QString& source,
                   const QString& operatorName)
{
    NewGrasp grasp;
    grasp.recording = recording;
    // The first one stands for the squeeze: the object alone. The others stay as they were measured.
    const Estimate* const recommended = identification.find(identification.recommended);
    if (recommended != nullptr && recommended->hasAnswer()) {
        Estimate alone = *recommended;
        const std::optional<CorrectedParameters> object = identification.object();
        alone.parameters = object ? std::optional(object->parameters) : std::nullopt;
        if (alone.covariance)
            alone.covariance = object ? std::optional(object->covariance) : std::nullopt;
        grasp.estimates.push_back(std::move(alone));
    }
    for (const Estimate& estimate : identification.estimates)
        if (&estimate != recommended || !estimate.hasAnswer())
            grasp.estimates.push_back(estimate);
    grasp.determined = determinedQuantities(identification, recording.forceUnit, recording.positionUnit);
    grasp.forceUnit = recording.forceUnit;
    grasp.positionUnit = recording.positionUnit;
    grasp.source = source;
    grasp.operatorName = operatorName;
    grasp.identification = documentToKeep(identification, recording, source);
    return grasp;
}

Expected<StoredType> findStoredType(Library& library, const QString& name)
{
    ASSIGN_OR_RETURN(const std::optional<TypeRecord> type, library.findType(name));
    StoredType found{type, {}};
    if (!found.type)
        return found;
    if (found.type->status == TypeStatus::Retired)
        return failure(
            ErrorCode::Usage,
            {Words::tr("%1 is retired. Put it back into use first, or choose another name.").arg(name)});
    ASSIGN_OR_RETURN(std::vector<GraspRecord> grasps, library.grasps(found.type->id));
    found.grasps = std::move(grasps);
    return found;
}

Expected<StoredEnrollment> findStoredEnrollment(Library& library, const QString& name, bool withDraft)
{
    ASSIGN_OR_RETURN(StoredType stored, findStoredType(library, name));
    StoredEnrollment found;
    found.stored = std::move(stored);
    if (!withDraft)
        return found;
    ASSIGN_OR_RETURN(std::optional<EnrollmentDraft> draft, library.draft(name));
    found.draft = std::move(draft);
    if (found.draft && !found.draft->pendingId.isEmpty()) {
        ASSIGN_OR_RETURN(DraftSqueeze pending, library.draftSqueeze(found.draft->pendingId));
        found.pending = std::move(pending);
    }
    Expected<std::optional<PartPicture>> picture = std::optional<PartPicture>();
    if (found.draft && !found.draft->pictureId.isEmpty())
        picture = library.picture(found.draft->pictureId).map([](PartPicture p) { return std::optional(p); });
    else if (found.stored.type)
        picture = library.typePicture(found.stored.type->id);
    if (!picture)
        return tl::unexpected<Error>(picture.error());
    found.picture = std::move(*picture);
    return found;
}

namespace {

Expected<TypeRecord> typeFor(Library& library, const SqueezeToStore& squeeze)
{
    ASSIGN_OR_RETURN(std::optional<TypeRecord> known, library.findType(squeeze.name));
    if (known)
        return *known;
    const NewGrasp& grasp = squeeze.grasp;
    Expected<TypeRecord> added = library.addType(squeeze.name, squeeze.recipe, grasp.forceUnit,
                                                 grasp.positionUnit, grasp.operatorName);
    if (!added || !squeeze.draft || squeeze.draft->pictureId.isEmpty())
        return added;
    RETURN_IF_ERROR(library.setTypePicture(added->id, squeeze.draft->pictureId, grasp.operatorName));
    return added;
}

Expected<StoredSqueeze> storeAll(Library& library, const SqueezeToStore& squeeze)
{
    ASSIGN_OR_RETURN(const TypeRecord type, typeFor(library, squeeze));
    NewGrasp grasp = squeeze.grasp;
    RETURN_IF_ERROR(parameterFactor(grasp.forceUnit, grasp.positionUnit, type.forceUnit, type.positionUnit));
    StoredSqueeze stored{type, squeeze.graspId};
    if (stored.graspId.isEmpty()) {
        grasp.typeId = type.id;
        ASSIGN_OR_RETURN(const GraspRecord added, library.addGrasp(grasp));
        stored.graspId = added.id;
    } else if (const Expected<void> back = library.undropGrasp(stored.graspId, grasp.operatorName); !back) {
        return tl::unexpected<Error>(back.error());
    }
    if (squeeze.draft)
        RETURN_IF_ERROR(library.saveDraft(*squeeze.draft));
    return stored;
}

} // namespace

Expected<StoredSqueeze> storeSqueeze(Library& library, const SqueezeToStore& squeeze)
{
    Expected<StoredSqueeze> stored = StoredSqueeze{};
    const Expected<void> done = library.atOnce([&]() -> Expected<void> {
        stored = storeAll(library, squeeze);
        return stored ? Expected<void>() : tl::unexpected<Error>(stored.error());
    });
    return done ? stored : tl::unexpected<Error>(done.error());
}

EnrollSqueeze enrolledSqueeze(const GraspRecord& grasp)
{
    EnrollSqueeze squeeze;
    squeeze.decision = EnrollSqueeze::Decision::Accepted;
    squeeze.graspId = grasp.id;
    squeeze.part = grasp.part;
    squeeze.determined = grasp.determined;
    squeeze.recording.forceUnit = grasp.forceUnit;
    squeeze.recording.positionUnit = grasp.positionUnit;
    Estimate estimate;
    estimate.estimator = grasp.estimator;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = grasp.parameters;
    estimate.covariance = grasp.covariance;
    estimate.fit.simulationPercent = grasp.simulationFitPercent;
    squeeze.identification.recommended = grasp.estimator;
    squeeze.identification.estimates = {estimate};
    return squeeze;
}

std::vector<DeterminedParameter> determinedParameters(const EnrollSqueeze& squeeze)
{
    const Recording& recording = squeeze.recording;
    const bool isStored = squeeze.identification.validity.checks.empty();
    if (isStored && squeeze.determined)
        return determinedParameters(*squeeze.determined, recording.forceUnit, recording.positionUnit);
    return determinedParameters(squeeze.identification, recording.forceUnit, recording.positionUnit);
}

QString whyNotEnrolled(const Identification& identification,
                       const std::optional<DeterminedQuantities>& determined)
{
    for (const ValidityCheck& check : identification.validity.checks)
        if (!check.ok && check.decisive)
            return check.message.describe();
    const Estimate* const recommended = identification.find(identification.recommended);
    if (recommended != nullptr && (identification.best() != nullptr || determined))
        return identification.validity.verdict == ValidityVerdict::Invalid ? recommended->message.describe()
                                                                           : QString();
    const QString message =
        identification.estimates.empty() ? QString() : identification.estimates.back().message.describe();
    return message.isEmpty() ? Words::tr("Nothing that parts can be told apart by was found in it.")
                             : message;
}

bool sameMeasurement(const EnrollSqueeze& one, const EnrollSqueeze& other)
{
    const auto parametersOf = [](const EnrollSqueeze& squeeze) {
        const auto object = squeeze.identification.object();
        return object ? std::optional(object->parameters) : std::nullopt;
    };
    const auto mine = parametersOf(one), theirs = parametersOf(other);
    if (mine != theirs || one.determined.has_value() != other.determined.has_value())
        return false;
    if (one.determined)
        return one.determined->space == other.determined->space &&
               one.determined->log == other.determined->log;
    return mine.has_value();
}

std::optional<Error> recipeError(const Recipe& recipe)
{
    const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
    if (!positive(recipe.peak_N) || !positive(recipe.bit_s) || !positive(recipe.seconds) ||
        !positive(recipe.maxForce_N) || !positive(recipe.maxTravel_m))
        return Error{ErrorCode::Usage,
                     {Words::tr("Peak force, bit, length and limits of a recipe must be above zero.")}};
    if (!std::isfinite(recipe.bias_N) || recipe.bias_N < 0)
        return Error{ErrorCode::Usage, {Words::tr("The preload of a recipe must be zero or above.")}};
    if (recipe.bias_N + recipe.peak_N > recipe.maxForce_N)
        return Error{ErrorCode::LimitExceeded,
                     {Words::say("Preload plus peak force"),
                      Finding::quantity(MechanicalQuantity::Force, recipe.bias_N + recipe.peak_N),
                      Finding::quantity(MechanicalQuantity::Force, recipe.maxForce_N),
                      Words::say("the recipe's")}};
    return std::nullopt;
}

} // namespace gripscope
