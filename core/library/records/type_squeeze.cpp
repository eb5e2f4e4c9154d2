// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/type_squeeze.h"

#include "core/recognition/types/squeeze_values.h"
#include "core/signal/recording/units.h"

namespace gripscope {

std::optional<TypeSqueeze> typeSqueeze(const GraspRecord& grasp)
{
    std::optional<TypeSqueeze> linear;
    if (grasp.parameters)
        linear = scaledSqueeze(grasp.typeName, *grasp.parameters, grasp.covariance,
                               siFactor(grasp.forceUnit, grasp.positionUnit).value_or(1));
    std::optional<TypeSqueeze> squeeze = foundSqueeze(grasp.typeName, std::move(linear), grasp.determined);
    if (!squeeze)
        return {};
    const bool moved = grasp.firstTypeId != grasp.typeId && !grasp.part.isEmpty();
    squeeze->part = moved ? grasp.firstTypeId + u'/' + grasp.part : grasp.part;
    return squeeze;
}

} // namespace gripscope
