// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/recipe_design.h"

#include "core/identification/design/excitation_design.h"

#include <Eigen/Cholesky>

#include <algorithm>
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

} // namespace gripscope
