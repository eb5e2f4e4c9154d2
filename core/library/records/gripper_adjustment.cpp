// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/gripper_adjustment.h"

#include "core/base/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Finding adjustmentInWords(const CommonShift& error)
{
    return changeInWords(error.value, error.covariance, error.space);
}

Findings adjustmentSignals(const AdjustmentStanding& standing)
{
    Findings told;
    if (standing.calibratedSince)
        told.push_back(
            Words::say("The adjustment of this gripper is older than its calibration of %1: what was "
                       "corrected then may be corrected twice. Measure the adjustment again, or "
                       "withdraw it.")
                .arg(standing.calibratedSince->toLocalTime().toString(u"yyyy-MM-dd hh:mm"_s)));
    if (!standing.ownTypes.isEmpty())
        told.push_back(
            Words::say("%1 was enrolled on this gripper itself, whose squeezes are adjusted to another: "
                       "its parts are judged wrongly. Enrol it on the other gripper, or withdraw the "
                       "adjustment.")
                .arg(standing.ownTypes.join(u", "_s)));
    return told;
}

} // namespace gripscope
