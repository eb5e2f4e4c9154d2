// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/recipe_design.h"

#include "core/identification/design/excitation_design.h"
#include "core/identification/motion/expected_deviations.h"
#include "core/math/normal_interval.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

constexpr std::size_t mostTypes = 12;

/// Those whose nearest neighbour is nearest, in the order of the models.
std::vector<TypeModel> hardestToTell(const TypeModels& types)
{
    if (types.types.size() <= mostTypes)
        return types.types;
    const Eigen::Index p = types.covarianceLog.rows();
    const bool scattered = types.degreesOfFreedom > 0;
    const Eigen::LLT<LogMatrix> scatter(scattered ? types.covarianceLog : LogMatrix::Identity(p, p));
    std::vector<std::pair<double, std::size_t>> nearest;
    for (std::size_t i = 0; i < types.types.size(); ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < types.types.size(); ++j)
            if (i != j)
                least = std::min(
                    least,
                    scatter.matrixL().solve(types.types[i].meanLog - types.types[j].meanLog).squaredNorm());
        nearest.emplace_back(least, i);
    }
    std::ranges::nth_element(nearest, nearest.begin() + mostTypes);
    nearest.resize(mostTypes);
    std::ranges::sort(nearest, {}, &std::pair<double, std::size_t>::second);
    std::vector<TypeModel> hardest;
    hardest.reserve(nearest.size());
    for (const auto& [distance, place] : nearest)
        hardest.push_back(types.types[place]);
    return hardest;
}

std::vector<DesignObject> objectsOf(const TypeModels& types)
{
    std::vector<DesignObject> objects;
    if (types.space == QuantitySpace{})
        for (const TypeModel& type : hardestToTell(types)) {
            const Eigen::Vector3d mean = type.meanLog.array().exp();
            DesignObject object{type.name, {mean(0), mean(1), mean(2)}};
            if (types.degreesOfFreedom > 0)
                object.covariance = mean.asDiagonal() * types.covarianceLog * mean.asDiagonal();
            objects.push_back(std::move(object));
        }
    if (objects.empty()) {
        const ExpectedPart part;
        objects.push_back({{}, {part.m_kg, part.b_Ns_per_m, part.k_N_per_m}});
    }
    return objects;
}

using P = MotionParameter;

constexpr std::size_t longestExpected = 100'000;

MotionValues valuesOf(const ExpectedPart& part, const Recipe& recipe)
{
    MotionValues values;
    values[P::Mass] = part.m_kg;
    values[P::Damping] = part.b_Ns_per_m;
    values[P::Stiffness] = part.k_N_per_m;
    values[P::Friction] = part.frictionShare * recipe.peak_N;
    values[P::Relaxing] = part.relaxingShare * part.k_N_per_m;
    values[P::RelaxationTime] = part.relaxationShare * recipe.seconds;
    return values;
}

} // namespace

Expected<ForceLevels> designedForce(const Recipe& recipe, const GripperIdentity& identity,
                                    const TypeModels& types)
{
    DesignOptions options;
    options.objects = objectsOf(types);
    options.peak = recipe.peak_N;
    options.bias = recipe.bias_N;
    options.limit = recipe.maxForce_N;
    options.duration_s = recipe.seconds;
    options.sampleTime_s = identity.sampleTime_s;
    options.shortestRun_s = recipe.bit_s;
    options.noiseDeviation = ExpectedPart().noise_m;
    options.hold = identity.hold;
    ASSIGN_OR_RETURN(const ExcitationDesign design, designExcitation(options));
    const auto binary =
        std::ranges::find(design.candidates, DesignKind::OptimizedBinary, &DesignCandidate::kind);
    if (binary == design.candidates.end())
        return failure(ErrorCode::NotFound, {toString(DesignKind::OptimizedBinary)});
    return levelsOf(binary->force, options.sampleTime_s, {}, toString(DesignKind::OptimizedBinary));
}

std::optional<double> ModelExpectation::of(MotionParameter parameter) const
{
    const std::vector<P> own = terms.parameters();
    const auto at = static_cast<std::size_t>(std::ranges::find(own, parameter) - own.begin());
    return at < relative.size() ? std::optional(relative[at]) : std::nullopt;
}

std::vector<ModelExpectation> expectationOf(const Recipe& recipe, const GripperIdentity& identity,
                                            const ExpectedPart& part)
{
    if (forceProblem(recipe, identity))
        return {};
    const ExcitationOptions excitation = excitationOptions(recipe, identity, 1);
    if (excitation.samples > longestExpected)
        return {};
    const auto force = makeExcitation(excitation);
    if (!force)
        return {};
    const PlannedSqueeze squeeze{*force, recipe.bias_N, identity.sampleTime_s, identity.hold, part.noise_m};
    const MotionValues values = valuesOf(part, recipe);
    std::vector<ModelExpectation> all;
    for (const MotionTerms& terms :
         std::array{MotionTerms{}, MotionTerms{.friction = true}, MotionTerms{.relaxation = true}}) {
        ModelExpectation one{terms, {}};
        const std::vector<P> parameters = terms.parameters();
        if (const auto deviations = expectedDeviations(terms, values, squeeze))
            for (std::size_t i = 0; i < parameters.size(); ++i)
                one.relative.push_back(normal95 * (*deviations)[i] / values[parameters[i]]);
        all.push_back(std::move(one));
    }
    return all;
}

} // namespace gripscope
