// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/link_words.h"

#include "core/base/words.h"
#include "core/session/connection/stop_words.h"
#include "core/signal/recording/recording.h"

namespace gripscope {

using namespace protocol;
using namespace Qt::StringLiterals;

QString deviceReason(std::uint16_t status, bool screenStoodStill)
{
    const bool limit = status & (StatusFault | StatusForceLimit | StatusTravelLimit);
    if (screenStoodStill && !limit && (status & StatusWatchdog))
        return Words::tr("the program's window stood still, so that nobody could have pressed Stop");
    const QString reason = ownReason(status);
    return reason.isEmpty() ? Words::tr("it disarmed itself, without a reason") : reason;
}

QString inWords(const CommandBody& body)
{
    switch (reportId(body)) {
    case ReportId::Arm:
        return Words::tr("arm");
    case ReportId::Disarm:
        return Words::tr("disarm");
    case ReportId::Stop:
        return Words::tr("confirm the stop");
    case ReportId::SetLimits:
        return Words::tr("take the limits of the squeeze");
    case ReportId::Upload:
        return Words::tr("take the force signal");
    case ReportId::Start:
        return Words::tr("start the squeeze");
    case ReportId::Finish:
        return Words::tr("end the squeeze early");
    default:
        return Words::tr("answer");
    }
}

Error refusal(const CommandQueue::Outcome& outcome)
{
    const QString asked = inWords(outcome.body);
    if (!outcome.result)
        return {ErrorCode::DeviceTimeout,
                {asked, Finding::number(std::chrono::duration<double>(outcome.waited).count())}};
    return {ErrorCode::DeviceRefused,
            {asked, describe(reportId(outcome.body), *outcome.result, outcome.detail)}};
}

} // namespace gripscope
