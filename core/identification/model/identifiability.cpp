// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/identifiability.h"

#include "core/base/words.h"

#include <array>

namespace gripscope {

Finding boundaryMessage(int parameter, bool atZero)
{
    static constexpr std::array<const char*, 3> toZero{
        QT_TRANSLATE_NOOP("Words", "the mass cannot be told from zero; excite faster, or sample faster"),
        QT_TRANSLATE_NOOP("Words", "the damping cannot be told from zero; squeeze longer or with more force"),
        QT_TRANSLATE_NOOP("Words", "the stiffness cannot be told from zero; squeeze longer")};
    static constexpr std::array<const char*, 3> toInfinity{
        QT_TRANSLATE_NOOP("Words", "no finite mass explains the position; check the grip and the sensor"),
        QT_TRANSLATE_NOOP("Words", "no finite damping explains the position; check the grip and the sensor"),
        QT_TRANSLATE_NOOP("Words",
                          "no finite stiffness explains the position; check the grip and the sensor")};
    const auto i = static_cast<std::size_t>(parameter);
    return Words::say(atZero ? toZero[i] : toInfinity[i]);
}

Estimate statusOnly(Estimator estimator, EstimateStatus status, Finding message)
{
    Estimate estimate;
    estimate.estimator = estimator;
    estimate.status = status;
    estimate.message = message;
    return estimate;
}

} // namespace gripscope
