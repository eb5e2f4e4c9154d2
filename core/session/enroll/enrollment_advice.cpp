// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/enroll/enrollment_advice.h"

#include "core/recognition/types/squeeze_values.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gripscope {

namespace {

std::optional<TypeSqueeze> typeSqueezeOf(const QString& type, const EnrollSqueeze& squeeze)
{
    const Recording& recording = squeeze.recording;
    std::optional<TypeSqueeze> linear;
    if (const std::optional<CorrectedParameters> object = squeeze.identification.object())
        linear =
            scaledSqueeze(type, *object, siFactor(recording.forceUnit, recording.positionUnit).value_or(1));
    std::optional<TypeSqueeze> result = foundSqueeze(type, std::move(linear), squeeze.determined);
    if (result)
        result->part = squeeze.part;
    return result;
}

bool areSame(const TypeSqueeze& one, const TypeSqueeze& other)
{
    const auto logs = [](const TypeSqueeze& squeeze) {
        return squeeze.determined ? std::optional(squeeze.determined->log) : std::nullopt;
    };
    return one.type == other.type && one.parameters == other.parameters && one.part == other.part &&
           logs(one) == logs(other);
}

/// The accepted squeezes, then those of the other types.
std::vector<TypeSqueeze> withOthers(const AdviceRequest& request, const std::vector<TypeSqueeze>& library)
{
    std::vector<TypeSqueeze> all = request.accepted;
    std::copy_if(library.begin(), library.end(), std::back_inserter(all),
                 [&](const TypeSqueeze& squeeze) { return squeeze.type != request.type; });
    return all;
}

VerdictOptions optionsFor(const AdviceRequest& request)
{
    VerdictOptions options = request.rates;
    options.siUnits = request.siUnits;
    return options;
}

std::map<int, SqueezeOutlier> outliersByRow(const AdviceRequest& request, std::vector<TypeSqueeze> all)
{
    const std::size_t accepted = request.accepted.size();
    if (request.pending)
        all.push_back(*request.pending);
    std::map<int, SqueezeOutlier> outliers;
    for (SqueezeOutlier& outlier : findOutliers(all, request.type)) {
        const int row = outlier.index < accepted ? request.rows[outlier.index] : request.pendingRow;
        outliers.emplace(row, std::move(outlier));
    }
    return outliers;
}

std::optional<double> stiffnessDeviation(const QuantitySpace& space,
                                         const std::optional<LogMatrix>& covariance)
{
    const std::optional<int> place = space.placeOf(TypeQuantity::Stiffness);
    if (!covariance || !place)
        return {};
    return std::sqrt(std::max(0.0, (*covariance)(*place, *place)));
}

} // namespace

bool operator==(const AdviceRequest& one, const AdviceRequest& other)
{
    const bool samePending = one.pending.has_value() == other.pending.has_value() &&
                             (!one.pending || areSame(*one.pending, *other.pending));
    return samePending && one.type == other.type && one.rows == other.rows &&
           one.pendingRow == other.pendingRow && one.rates == other.rates &&
           std::equal(one.accepted.begin(), one.accepted.end(), other.accepted.begin(), other.accepted.end(),
                      areSame);
}

AdviceRequest adviceRequest(const QString& type, const std::vector<EnrollSqueeze>& squeezes,
                            const VerdictOptions& rates)
{
    AdviceRequest request;
    request.type = type;
    request.rates = rates;
    for (std::size_t row = 0; row < squeezes.size(); ++row) {
        const EnrollSqueeze& squeeze = squeezes[row];
        if (squeeze.decision == EnrollSqueeze::Decision::Rejected)
            continue;
        std::optional<TypeSqueeze> found = typeSqueezeOf(type, squeeze);
        if (!found)
            continue;
        request.siUnits = siFactor(squeeze.recording.forceUnit, squeeze.recording.positionUnit).has_value();
        if (squeeze.decision == EnrollSqueeze::Decision::Accepted) {
            request.accepted.push_back(std::move(*found));
            request.rows.push_back(int(row));
        } else if (squeeze.reason.isEmpty()) { // one that may not be enrolled needs no advice
            request.pending = std::move(found);
            request.pendingRow = int(row);
        }
    }
    return request;
}

EnrollmentAdvice advise(const AdviceRequest& request, const std::vector<TypeSqueeze>& library)
{
    std::vector<TypeSqueeze> all = withOthers(request, library);
    EnrollmentAdvice advice;
    advice.progress = enrollmentProgress(fitTypeModels(all, spaceOf(all)), request.type, optionsFor(request));
    advice.outliers = outliersByRow(request, std::move(all));
    return advice;
}

EnrollmentReview reviewEnrollment(const AdviceRequest& request, const std::vector<TypeSqueeze>& library)
{
    const std::vector<TypeSqueeze> all = withOthers(request, library);
    const ModelsBySpace types(all);
    const TypeModels& models = *types.whole();
    const VerdictOptions options = optionsFor(request);
    EnrollmentReview review;
    review.advice = advise(request, library);
    review.overlap = worstOverlap(types, request.type, options);
    review.confusion = heldOutConfusion(all, options);
    review.partDeviation = stiffnessDeviation(models.space, models.scatter.partToPart);
    review.regripDeviation = stiffnessDeviation(models.space, models.scatter.regrip);
    return review;
}

} // namespace gripscope
