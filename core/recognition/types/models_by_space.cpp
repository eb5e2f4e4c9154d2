// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/models_by_space.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

namespace gripscope {

namespace {

using Reach = TypeModels::Reach;

ModelsBySpace::Models fitted(const std::vector<TypeSqueeze>& squeezes, const QuantitySpace& space,
                             Reach reach)
{
    TypeModels models = fitTypeModels(squeezes, space);
    models.reach = reach;
    return std::make_shared<const TypeModels>(std::move(models));
}

} // namespace

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

ModelsBySpace::ModelsBySpace(std::vector<TypeSqueeze> squeezes)
    : m_squeezes(std::move(squeezes)), m_determined(m_squeezes), m_ownSpaces(m_determined.ownSpaces()),
      m_whole(fitted(m_squeezes, m_determined.space(), Reach::Whole)),
      m_linear(m_whole->space == QuantitySpace{} ? m_whole : fitted(m_squeezes, {}, Reach::Part))
{
}

ModelsBySpace::Models ModelsBySpace::fittedOnce(const QuantitySpace& space, Reach reach) const
{
    if (space == m_whole->space)
        return m_whole;
    if (space == m_linear->space && reach == Reach::Part)
        return m_linear;
    const std::lock_guard lock(m_mutex);
    Models& models = m_fitted[toString(space)];
    if (models)
        return models;
    if (reach == Reach::Part)
        return models = fitted(m_squeezes, space, reach);
    // A type of which few squeezes determine it would be known by those few alone.
    const QStringList types = m_determined.typesWith(space);
    std::vector<TypeSqueeze> own;
    std::ranges::copy_if(m_squeezes, std::back_inserter(own), [&](const TypeSqueeze& squeeze) {
        return std::ranges::binary_search(types, squeeze.type);
    });
    return models = fitted(own, space, reach);
}

ModelsBySpace::Models ModelsBySpace::modelsFor(const TypeSqueeze& squeeze) const
{
    const QuantitySpace space = determinedPart(squeeze, m_whole->space);
    return space.quantities.empty() ? m_whole : fittedOnce(space, Reach::Part);
}

bool ModelsBySpace::allDetermineTheSame() const
{
    return std::ranges::all_of(m_ownSpaces,
                               [this](const QuantitySpace& own) { return own == m_whole->space; });
}

bool ModelsBySpace::mayGoBeyond(const QuantitySpace& space, const TypeSqueeze& squeeze) const
{
    return std::ranges::any_of(m_ownSpaces, [&](const QuantitySpace& own) {
        return determinedPart(squeeze, own).dimensions() > space.dimensions();
    });
}

ModelsBySpace::Models ModelsBySpace::beyond(const QuantitySpace& space, const QStringList& types,
                                            const TypeSqueeze& squeeze) const
{
    const QuantitySpace larger = determinedPart(squeeze, m_determined.space(types));
    if (larger.dimensions() <= space.dimensions() || !larger.contains(space))
        return {};
    Models models = fittedOnce(larger, Reach::Group);
    return models->gateRefuses() ? models : nullptr;
}

ModelsBySpace::Models ModelsBySpace::modelsAmong(const QStringList& types) const
{
    const QuantitySpace larger = m_determined.space(types);
    if (m_whole->space.contains(larger))
        return m_whole;
    Models models = fittedOnce(larger, Reach::Group);
    return models->gateRefuses() ? models : m_whole;
}

std::optional<double> ModelsBySpace::distance(const QString& one, const QString& other) const
{
    const Models models = modelsAmong({one, other});
    const TypeModel* from = models->find(one);
    const TypeModel* to = models->find(other);
    if (!from || !to)
        return {};
    const auto squared = squaredDistance(*models, *from, squeezeAt({}, models->space, to->meanLog));
    return squared ? std::optional(std::sqrt(*squared)) : std::nullopt;
}

} // namespace gripscope
