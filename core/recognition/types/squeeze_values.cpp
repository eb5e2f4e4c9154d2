// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/squeeze_values.h"

#include <algorithm>
#include <iterator>
#include <utility>

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

QuantitySpace within(const QuantitySpace& space, QuantitySet set)
{
    QuantitySpace part{{}};
    std::ranges::copy_if(space.quantities, std::back_inserter(part.quantities), [set](TypeQuantity quantity) {
        return (set >> static_cast<unsigned>(quantity) & 1U) != 0;
    });
    return part;
}

} // namespace

QuantitySet setOf(const QuantitySpace& space)
{
    QuantitySet set = 0;
    for (const TypeQuantity quantity : space.quantities)
        set |= 1U << static_cast<unsigned>(quantity);
    return set;
}

QuantitySpace spaceFrom(QuantitySet set)
{
    return within({{std::begin(allQuantities), std::end(allQuantities)}}, set);
}

Determines determinedBy(const TypeSqueeze& squeeze)
{
    Determines kind;
    for (unsigned i = 0; i < mostDimensions; ++i)
        if (isDetermined(squeeze, {{allQuantities[i]}}))
            kind.first |= 1U << i;
    if (isUsable(squeeze.parameters))
        kind.second = setOf({});
    return kind;
}

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

QuantitySpace determinedPart(const TypeSqueeze& squeeze, const QuantitySpace& space)
{
    const auto [determined, linear] = determinedBy(squeeze);
    QuantitySpace first = within(space, determined);
    QuantitySpace second = within(space, linear);
    return second.dimensions() > first.dimensions() ? second : first;
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

std::optional<TypeSqueeze> foundSqueeze(const QString& type, std::optional<TypeSqueeze> linear,
                                        std::optional<DeterminedQuantities> determined)
{
    if (!linear && !determined)
        return {};
    const bool counts = linear && (!determined || determined->space.contains(QuantitySpace{}));
    TypeSqueeze squeeze = counts ? *std::move(linear) : TypeSqueeze{type, {}};
    squeeze.determined = std::move(determined);
    return squeeze;
}

} // namespace gripscope
