// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/quantity_name.h"

#include "core/base/words.h"

namespace gripscope {

Finding nameWithin(TypeQuantity quantity)
{
    switch (quantity) {
    case TypeQuantity::Mass:
        return Words::say("mass");
    case TypeQuantity::Damping:
        return Words::say("damping");
    case TypeQuantity::Stiffness:
        return Words::say("stiffness");
    case TypeQuantity::RelaxingShare:
        return Words::say("relaxing share");
    case TypeQuantity::RelaxationTime:
        return Words::say("relaxation time");
    case TypeQuantity::Friction:
        return Words::say("friction");
    }
    return {};
}

} // namespace gripscope
