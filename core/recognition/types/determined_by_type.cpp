// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/determined_by_type.h"

#include <algorithm>
#include <bit>

namespace gripscope {

DeterminedByType::DeterminedByType(const std::vector<TypeSqueeze>& squeezes)
{
    for (const TypeSqueeze& squeeze : squeezes)
        if (const Determines kind = determinedBy(squeeze); kind != Determines{})
            ++m_kinds[squeeze.type][kind];
}

bool DeterminedByType::mostDetermine(const Kinds& kinds, QuantitySet set)
{
    int all = 0;
    int determine = 0;
    for (const auto& [kind, count] : kinds) {
        all += count;
        if ((set & ~kind.first) == 0 || (set & ~kind.second) == 0)
            determine += count;
    }
    return 2 * determine > all;
}

QuantitySpace DeterminedByType::space(const QStringList& types) const
{
    std::vector<const Kinds*> asked;
    for (const QString& type : types)
        if (const auto found = m_kinds.constFind(type); found != m_kinds.cend())
            asked.push_back(&*found);
    if (asked.empty())
        return {};
    QuantitySet best = 0;
    for (QuantitySet set = 1; set < 1U << mostDimensions; ++set)
        if (std::popcount(set) > std::popcount(best) &&
            std::ranges::all_of(asked, [set](const Kinds* kinds) { return mostDetermine(*kinds, set); }))
            best = set;
    return spaceFrom(best);
}

QStringList DeterminedByType::typesWith(const QuantitySpace& space) const
{
    const QuantitySet set = setOf(space);
    QStringList types;
    for (auto it = m_kinds.cbegin(); it != m_kinds.cend(); ++it)
        if (mostDetermine(*it, set))
            types << it.key();
    return types;
}

std::vector<QuantitySpace> DeterminedByType::ownSpaces() const
{
    std::vector<QuantitySpace> spaces;
    for (auto it = m_kinds.cbegin(); it != m_kinds.cend(); ++it)
        if (QuantitySpace own = space({it.key()}); std::ranges::find(spaces, own) == spaces.end())
            spaces.push_back(std::move(own));
    return spaces;
}

QuantitySpace spaceOf(const std::vector<TypeSqueeze>& squeezes)
{
    return DeterminedByType(squeezes).space();
}

} // namespace gripscope
