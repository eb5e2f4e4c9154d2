// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/type_space.h"

#include "core/library/records/type_squeeze.h"
#include "core/recognition/types/models_by_space.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/types/squeeze_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What an ellipsoid holds: of a type's squeezes, of where a squeeze may lie.
constexpr double spaceShare = 0.95;

/// Types that lie close in what all determine may lie far apart in what two of them do, seldom the other way:
/// the closest of the first come first, and those that cannot be the nearest are not asked.
std::optional<TypeSpace::Pair> nearestPair(const ModelsBySpace& types)
{
    const TypeModels& models = *types.whole();
    std::vector<TypeSpace::Pair> pairs;
    for (std::size_t i = 0; i < models.types.size(); ++i)
        for (std::size_t j = i + 1; j < models.types.size(); ++j) {
            const TypeSqueeze mean = squeezeAt({}, models.space, models.types[j].meanLog);
            if (const auto squared = squaredDistance(models, models.types[i], mean))
                pairs.push_back({models.types[i].name, models.types[j].name, std::sqrt(*squared)});
        }
    std::ranges::sort(pairs, {}, &TypeSpace::Pair::distance);
    std::optional<TypeSpace::Pair> nearest;
    for (TypeSpace::Pair& pair : pairs) {
        if (nearest && pair.distance >= nearest->distance)
            break;
        pair.distance = types.distance(pair.one, pair.other).value_or(pair.distance);
        if (!nearest || pair.distance < nearest->distance)
            nearest = pair;
    }
    return nearest;
}

/// Fills in what follows from `types` and `squeezes`. `others`: those of the types that have no place here.
void complete(TypeSpace& space, std::vector<TypeSqueeze> others = {})
{
    std::vector<TypeSqueeze> squeezes = std::move(others);
    squeezes.reserve(squeezes.size() + space.squeezes.size());
    space.counts.assign(std::size_t(space.types.size()), 0);
    for (const SpaceSqueeze& squeeze : space.squeezes) {
        squeezes.push_back({space.types[squeeze.type], squeeze.parameters});
        squeezes.back().determined = squeeze.determined;
        ++space.counts[std::size_t(squeeze.type)];
    }
    const ModelsBySpace models(std::move(squeezes));
    space.models = *models.linear();
    for (const QString& name : space.types) {
        const TypeModel* type = space.models.find(name);
        space.ellipsoids.push_back(type ? typeEllipsoid(space.models, *type, spaceShare) : std::nullopt);
    }
    const TypeModels& whole = *models.whole();
    const std::size_t all = std::size_t(space.types.size()) + space.elsewhere.size();
    if (whole.types.size() == all && whole.degreesOfFreedom > 0)
        space.nearest = nearestPair(models);
}

/// The accepted ones, as recognition takes them.
std::vector<TypeSqueeze> squeezesOf(const std::vector<GraspRecord>& grasps)
{
    std::vector<TypeSqueeze> squeezes;
    for (const GraspRecord& grasp : grasps)
        if (const auto squeeze = grasp.accepted ? typeSqueeze(grasp) : std::nullopt)
            squeezes.push_back(*squeeze);
    return squeezes;
}

} // namespace

const SpaceSqueeze* TypeSpace::find(const QString& id) const
{
    const auto found = std::find_if(squeezes.begin(), squeezes.end(),
                                    [&](const SpaceSqueeze& squeeze) { return squeeze.id == id; });
    return found == squeezes.end() ? nullptr : &*found;
}

std::optional<Ellipsoid> ownEllipsoid(const SpaceSqueeze& squeeze)
{
    if (!squeeze.covariance || squeeze.covariance->isZero(0))
        return {};
    return estimateEllipsoid(squeeze.parameters, *squeeze.covariance, spaceShare);
}

TypeSpace paperTypeSpace()
{
    TypeSpace space;
    space.paper = true;
    space.units = parameterUnits(u"1"_s, u"1"_s);
    for (const TypeSqueeze& squeeze : paperSqueezesAsPrinted()) {
        if (space.types.isEmpty() || space.types.last() != squeeze.type) {
            space.signs.push_back(int(space.types.size()));
            space.types << squeeze.type; // the appendix is in order
        }
        const int number = space.squeezes.empty() || space.squeezes.back().type != int(space.types.size()) - 1
                               ? 1
                               : space.squeezes.back().number + 1;
        space.squeezes.push_back({u"%1 %2"_s.arg(squeeze.type, QString::number(number)),
                                  int(space.types.size()) - 1, number, squeeze.parameters, false});
    }
    complete(space);
    return space;
}

Expected<TypeSpace> libraryTypeSpace(Library& library)
{
    ASSIGN_OR_RETURN(const std::vector<TypeRecord> types, library.types());
    TypeSpace space;
    space.units = siParameterUnits();
    std::vector<TypeSqueeze> others;
    for (const TypeRecord& type : types) {
        ASSIGN_OR_RETURN(const std::vector<GraspRecord> grasps, library.grasps(type.id));
        const int index = int(space.types.size());
        int number = 0;
        for (const GraspRecord& grasp : grasps) {
            if (!grasp.accepted || !grasp.parameters)
                continue;
            const std::optional<double> si = siFactor(grasp.forceUnit, grasp.positionUnit);
            if (!si)
                space.units = parameterUnits(grasp.forceUnit, grasp.positionUnit);
            const auto [m, b, k] = *grasp.parameters;
            const double factor = si.value_or(1);
            SpaceSqueeze squeeze{
                grasp.id, index, ++number, {m * factor, b * factor, k * factor}, grasp.hasRecording};
            if (grasp.covariance)
                squeeze.covariance = *grasp.covariance * (factor * factor);
            squeeze.determined = grasp.determined;
            space.squeezes.push_back(std::move(squeeze));
        }
        if (number > 0) {
            space.types << type.name;
            space.signs.push_back(type.place);
            continue;
        }
        const std::vector<TypeSqueeze> own = squeezesOf(grasps);
        if (!own.empty())
            space.elsewhere.push_back({type.name, int(own.size())});
        others.insert(others.end(), own.begin(), own.end());
    }
    complete(space, std::move(others));
    return space;
}

} // namespace gripscope
