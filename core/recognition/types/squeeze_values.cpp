// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/squeeze_values.h"

#include <QMap>

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
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

using QuantitySet = unsigned; ///< bit i: the i-th of allQuantities

/// What a squeeze's `determined` has, and what its m, b and k tell: the two are not mixed.
using Determines = std::pair<QuantitySet, QuantitySet>;

Determines determinedBy(const TypeSqueeze& squeeze)
{
    Determines kind;
    for (unsigned i = 0; i < mostDimensions; ++i)
        if (isDetermined(squeeze, {{allQuantities[i]}}))
            kind.first |= 1U << i;
    if (isUsable(squeeze.parameters))
        kind.second = 0b111; // m, b and k come first
    return kind;
}

/// Those of its quantities that the set has.
QuantitySpace within(const QuantitySpace& space, QuantitySet set)
{
    QuantitySpace part{{}};
    std::ranges::copy_if(space.quantities, std::back_inserter(part.quantities), [set](TypeQuantity quantity) {
        return (set >> static_cast<unsigned>(quantity) & 1U) != 0;
    });
    return part;
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

QuantitySpace spaceOf(const std::vector<TypeSqueeze>& squeezes)
{
    // Many squeezes, few that determine different things.
    QMap<QString, std::map<Determines, int>> kindsOfType;
    for (const TypeSqueeze& squeeze : squeezes)
        if (const Determines kind = determinedBy(squeeze); kind != Determines{})
            ++kindsOfType[squeeze.type][kind];
    if (kindsOfType.isEmpty())
        return {};
    const auto mostDetermine = [](const std::map<Determines, int>& kinds, QuantitySet set) {
        int all = 0;
        int determine = 0;
        for (const auto& [kind, count] : kinds) {
            all += count;
            if ((set & ~kind.first) == 0 || (set & ~kind.second) == 0)
                determine += count;
        }
        return 2 * determine > all;
    };
    QuantitySet best = 0;
    for (QuantitySet set = 1; set < 1U << mostDimensions; ++set)
        if (std::popcount(set) > std::popcount(best) &&
            std::all_of(kindsOfType.cbegin(), kindsOfType.cend(),
                        [&](const auto& kinds) { return mostDetermine(kinds, set); }))
            best = set;
    return within({{std::begin(allQuantities), std::end(allQuantities)}}, best);
}

} // namespace gripscope
