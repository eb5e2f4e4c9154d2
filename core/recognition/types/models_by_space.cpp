// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/models_by_space.h"

#include "core/recognition/types/squeeze_values.h"

#include <utility>

namespace gripscope {

namespace {

std::shared_ptr<const TypeModels> fitted(const std::vector<TypeSqueeze>& squeezes, const QuantitySpace& space,
                                         bool isPart)
{
    TypeModels models = fitTypeModels(squeezes, space);
    models.isPart = isPart;
    return std::make_shared<const TypeModels>(std::move(models));
}

} // namespace

ModelsBySpace::ModelsBySpace(std::vector<TypeSqueeze> squeezes)
    : m_squeezes(std::move(squeezes)), m_whole(fitted(m_squeezes, spaceOf(m_squeezes), false)),
      m_linear(m_whole->space == QuantitySpace{} ? m_whole : fitted(m_squeezes, {}, true))
{
}

std::shared_ptr<const TypeModels> ModelsBySpace::modelsFor(const TypeSqueeze& squeeze) const
{
    const QuantitySpace space = determinedPart(squeeze, m_whole->space);
    if (space.quantities.empty() || space == m_whole->space)
        return m_whole;
    if (space == m_linear->space)
        return m_linear;
    const std::lock_guard lock(m_mutex);
    std::shared_ptr<const TypeModels>& part = m_parts[toString(space)];
    if (!part)
        part = fitted(m_squeezes, space, true);
    return part;
}

} // namespace gripscope
