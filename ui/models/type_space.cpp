// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/type_space.h"

#include "core/recognition/paper_appendix.h"

#include <QCoreApplication>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::optional<TypeSpace::Pair> nearestPair(const TypeModels& models)
{
    std::optional<TypeSpace::Pair> nearest;
    for (std::size_t i = 0; i < models.types.size(); ++i)
        for (std::size_t j = i + 1; j < models.types.size(); ++j) {
            const Eigen::Vector3d mean = models.types[j].meanLog.array().exp();
            const std::optional<double> squared =
                squaredDistance(models, models.types[i], {mean.x(), mean.y(), mean.z()});
            if (squared && (!nearest || std::sqrt(*squared) < nearest->distance))
                nearest = TypeSpace::Pair{int(i), int(j), std::sqrt(*squared)};
        }
    return nearest;
}

/// Fills in what follows from `types` and `squeezes`.
void complete(TypeSpace& space)
{
    constexpr double share = 0.95;
    std::vector<TypeSqueeze> squeezes;
    space.counts.assign(std::size_t(space.types.size()), 0);
    for (const SpaceSqueeze& squeeze : space.squeezes) {
        squeezes.push_back({space.types[squeeze.type], squeeze.parameters});
        ++space.counts[std::size_t(squeeze.type)];
    }
    space.models = fitTypeModels(squeezes);
    for (const QString& name : space.types) {
        const TypeModel* type = space.models.find(name);
        space.ellipsoids.push_back(type ? typeEllipsoid(space.models, *type, share) : std::nullopt);
    }
    if (int(space.models.types.size()) == space.types.size() && space.models.degreesOfFreedom > 0)
        space.nearest = nearestPair(space.models);
}

} // namespace

TypeSpace paperTypeSpace()
{
    TypeSpace space;
    space.paper = true;
    space.units = parameterUnits(u"1"_s, u"1"_s);
    for (const TypeSqueeze& squeeze : paperSqueezesAsPrinted()) {
        if (space.types.isEmpty() || space.types.last() != squeeze.type)
            space.types << squeeze.type; // the appendix is in order
        const int number = space.squeezes.empty() || space.squeezes.back().type != int(space.types.size()) - 1
                               ? 1
                               : space.squeezes.back().number + 1;
        space.squeezes.push_back({u"%1 %2"_s.arg(squeeze.type).arg(number), int(space.types.size()) - 1,
                                  number, squeeze.parameters, false});
    }
    complete(space);
    return space;
}

Expected<TypeSpace> libraryTypeSpace(Library& library)
{
    const Expected<std::vector<TypeRecord>> types = library.types();
    if (!types)
        return tl::unexpected<Error>(types.error());
    TypeSpace space;
    space.units = parameterUnits(u"N"_s, u"m"_s);
    for (const TypeRecord& type : *types) {
        const Expected<std::vector<GraspRecord>> grasps = library.grasps(type.id);
        if (!grasps)
            return tl::unexpected<Error>(grasps.error());
        const int index = int(space.types.size());
        int number = 0;
        for (const GraspRecord& grasp : *grasps) {
            if (!grasp.accepted || !grasp.parameters)
                continue;
            const std::optional<double> si = siFactor(grasp.forceUnit, grasp.positionUnit);
            if (!si)
                space.units = parameterUnits(grasp.forceUnit, grasp.positionUnit);
            const auto [m, b, k] = *grasp.parameters;
            const double factor = si.value_or(1);
            space.squeezes.push_back(
                {grasp.id, index, ++number, {m * factor, b * factor, k * factor}, grasp.hasRecording});
        }
        if (number > 0)
            space.types << type.name;
    }
    complete(space);
    return space;
}

Expected<SpaceClustering> clusterTypeSpace(const TypeSpace& space, FeatureScaling scaling, int start)
{
    if (space.types.size() < 2)
        return failure(ErrorCode::Usage, {QCoreApplication::translate("gripscope::TypeSpace",
                                                                      "clusters need at least two types")});
    Eigen::MatrixXd features(Eigen::Index(space.squeezes.size()), 3);
    QStringList truth;
    for (std::size_t i = 0; i < space.squeezes.size(); ++i) {
        features.row(Eigen::Index(i)) = space.squeezes[i].parameters.vector().transpose();
        truth << space.types[space.squeezes[i].type];
    }
    const Expected<FeatureTransform> transform = featureTransform(features, scaling);
    if (!transform)
        return tl::unexpected<Error>(transform.error());
    KMeansOptions options;
    options.clusters = int(space.types.size());
    if (start > 0) {
        options.restarts = 1;
        options.candidates = 1;
        options.seed = std::uint64_t(start);
    }
    Expected<KMeansResult> result = kMeans(transform->apply(features), options);
    if (!result)
        return tl::unexpected<Error>(result.error());
    SpaceClustering clustering;
    clustering.scaling = scaling;
    clustering.agreement = clusterAgreement(truth, result->labels, options.clusters);
    clustering.table = clusterTable(truth, result->labels);
    for (const KMeansStep& step : result->steps)
        clustering.centroids.push_back(transform->undo(step.centroids));
    clustering.result = std::move(*result);
    return clustering;
}

} // namespace gripscope
