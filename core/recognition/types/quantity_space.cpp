// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/quantity_space.h"

#include <QStringList>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

QString symbolOf(TypeQuantity quantity)
{
    switch (quantity) {
    case TypeQuantity::Mass:
        return u"m"_s;
    case TypeQuantity::Damping:
        return u"b"_s;
    case TypeQuantity::Stiffness:
        return u"k"_s;
    case TypeQuantity::RelaxingShare:
        return u"k1/k"_s;
    case TypeQuantity::RelaxationTime:
        return u"tau"_s;
    case TypeQuantity::Friction:
        return u"Fc"_s;
    }
    return {};
}

std::optional<int> QuantitySpace::placeOf(TypeQuantity quantity) const
{
    const auto it = std::find(quantities.begin(), quantities.end(), quantity);
    return it == quantities.end() ? std::nullopt : std::optional(int(it - quantities.begin()));
}

bool QuantitySpace::contains(const QuantitySpace& other) const
{
    return std::all_of(other.quantities.begin(), other.quantities.end(),
                       [&](TypeQuantity quantity) { return placeOf(quantity).has_value(); });
}

QString toString(const QuantitySpace& space)
{
    QStringList symbols;
    for (const TypeQuantity quantity : space.quantities)
        symbols << symbolOf(quantity);
    return symbols.join(u'+');
}

std::optional<QuantitySpace> quantitySpaceFromString(const QString& text)
{
    QuantitySpace space{{}};
    for (const QString& symbol : text.split(u'+')) {
        const auto* const found =
            std::find_if(std::begin(allQuantities), std::end(allQuantities),
                         [&](TypeQuantity quantity) { return symbolOf(quantity) == symbol; });
        if (found == std::end(allQuantities) || space.placeOf(*found))
            return {};
        space.quantities.push_back(*found);
    }
    return space;
}

} // namespace gripscope
