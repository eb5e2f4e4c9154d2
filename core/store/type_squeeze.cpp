// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/type_squeeze.h"

#include "core/signal/units.h"

namespace gripscope {

std::optional<TypeSqueeze> typeSqueeze(const GraspRecord& grasp)
{
    if (!grasp.parameters)
        return {};
    const double si = siFactor(grasp.forceUnit, grasp.positionUnit).value_or(1);
    const MassDampingStiffness& p = *grasp.parameters;
    TypeSqueeze squeeze{grasp.typeName, {p.m * si, p.b * si, p.k * si}};
    if (grasp.covariance)
        squeeze.covariance = si * *grasp.covariance * si;
    const bool moved = grasp.firstTypeId != grasp.typeId && !grasp.part.isEmpty();
    squeeze.part = moved ? grasp.firstTypeId + u'/' + grasp.part : grasp.part;
    return squeeze;
}

} // namespace gripscope
