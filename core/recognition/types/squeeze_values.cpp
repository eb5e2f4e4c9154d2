// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/squeeze_values.h"

#include <algorithm>

namespace gripscope {

namespace {

/// Where the coordinates of `space` are among those of `of`, which contains it.
std::vector<int> placesIn(const QuantitySpace& of, const QuantitySpace& space)
{
    std::vector<int> places;
    for (const TypeQuantity quantity : space.quantities)
        places.push_back(of.placeOf(quantity).value_or(0));
    return places;
}

/// The squeeze's `determined` has every quantity of the space.
bool isDetermined(const TypeSqueeze& squeeze, const QuantitySpace& space)
{
    if (!squeeze.determined || space.quantities.empty() || space.dimensions() > mostDimensions)
        return false;
    const DeterminedQuantities& known = *squeeze.determined;
    if (known.log.size() != known.space.dimensions() || !known.space.contains(space))
        return false;
    const std::vector<int> places = placesIn(known.space, space);
    return std::all_of(places.begin(), places.end(),
                       [&](int place) { return std::isfinite(known.log(place)); });
}

} // namespace

std::optional<LogVector> coordinatesOf(const TypeSqueeze& squeeze, const QuantitySpace& space)
{
    const QuantitySpace motion;
    if (isDetermined(squeeze, space))
        return LogVector(squeeze.determined->log(placesIn(squeeze.determined->space, space)));
    const bool any = !space.quantities.empty() && space.dimensions() <= motion.dimensions();
    if (!any || !motion.contains(space) || !isUsable(squeeze.parameters))
        return {};
    const Eigen::Vector3d log = logOf(squeeze.parameters);
    return space == motion ? LogVector(log) : LogVector(log(placesIn(motion, space)));
}

std::optional<LogMatrix> noiseOf(const TypeSqueeze& squeeze, const QuantitySpace& space)
{
    const QuantitySpace motion;
    if (isDetermined(squeeze, space)) {
        const DeterminedQuantities& known = *squeeze.determined;
        if (!known.covariance || known.covariance->rows() != known.log.size() ||
            known.covariance->cols() != known.log.size())
            return {};
        const std::vector<int> places = placesIn(known.space, space);
        return usableLogCovariance((*known.covariance)(places, places));
    }
    const std::optional<Eigen::Matrix3d> log = noiseOf(squeeze);
    if (!log || !motion.contains(space))
        return {};
    const std::vector<int> places = placesIn(motion, space);
    return LogMatrix((*log)(places, places));
}

TypeSqueeze squeezeAt(QString type, const QuantitySpace& space, const LogVector& log,
                      const std::optional<LogMatrix>& covariance)
{
    TypeSqueeze squeeze{std::move(type), {}};
    squeeze.determined = DeterminedQuantities{space, log, covariance};
    return squeeze;
}

QuantitySpace spaceOf(const std::vector<TypeSqueeze>& squeezes)
{
    std::vector<const TypeSqueeze*> usable;
    for (const TypeSqueeze& squeeze : squeezes)
        if (std::any_of(std::begin(allQuantities), std::end(allQuantities), [&](TypeQuantity quantity) {
                return coordinatesOf(squeeze, QuantitySpace{{quantity}}).has_value();
            }))
            usable.push_back(&squeeze);
    if (usable.empty())
        return {};
    QuantitySpace largest{{}};
    for (unsigned set = 1; set < 1U << mostDimensions; ++set) {
        QuantitySpace space{{}};
        for (unsigned i = 0; i < mostDimensions; ++i)
            if ((set >> i & 1U) != 0)
                space.quantities.push_back(allQuantities[i]);
        const auto determines = [&](const TypeSqueeze* squeeze) {
            return coordinatesOf(*squeeze, space).has_value();
        };
        if (space.dimensions() > largest.dimensions() &&
            std::all_of(usable.begin(), usable.end(), determines))
            largest = std::move(space);
    }
    return largest;
}

} // namespace gripscope
