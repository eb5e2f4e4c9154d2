// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/line_values.h"

#include "core/base/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(LineState state)
{
    switch (state) {
    case LineState::Preoperational:
        return u"Preoperational"_s;
    case LineState::Initialized:
        return u"Initialized"_s;
    case LineState::Ready:
        return u"Ready"_s;
    case LineState::SingleExecution:
        return u"SingleExecution"_s;
    case LineState::ContinuousExecution:
        return u"ContinuousExecution"_s;
    case LineState::Halted:
        return u"Halted"_s;
    case LineState::Error:
        return u"Error"_s;
    }
    return {};
}

QString toString(ResultEvaluation evaluation)
{
    switch (evaluation) {
    case ResultEvaluation::Undefined:
        return u"Undefined"_s;
    case ResultEvaluation::Ok:
        return u"OK"_s;
    case ResultEvaluation::NotOk:
        return u"NotOK"_s;
    case ResultEvaluation::NotDecidable:
        return u"NotDecidable"_s;
    }
    return {};
}

QString toString(ResultState state)
{
    switch (state) {
    case ResultState::Undefined:
        return u"Undefined"_s;
    case ResultState::Completed:
        return u"Completed"_s;
    case ResultState::Processing:
        return u"Processing"_s;
    case ResultState::Aborted:
        return u"Aborted"_s;
    case ResultState::Failed:
        return u"Failed"_s;
    }
    return {};
}

QString toString(ResultReason reason)
{
    switch (reason) {
    case ResultReason::None:
        return u"None"_s;
    case ResultReason::AsExpected:
        return u"AsExpected"_s;
    case ResultReason::OtherType:
        return u"OtherType"_s;
    case ResultReason::Unknown:
        return u"Unknown"_s;
    case ResultReason::Inconclusive:
        return u"Inconclusive"_s;
    case ResultReason::NotValid:
        return u"NotValid"_s;
    case ResultReason::DoesNotConform:
        return u"DoesNotConform"_s;
    case ResultReason::NotMeasured:
        return u"NotMeasured"_s;
    }
    return {};
}

ResultEvaluation evaluationOf(ResultReason reason)
{
    switch (reason) {
    case ResultReason::None:
        return ResultEvaluation::Undefined;
    case ResultReason::AsExpected:
        return ResultEvaluation::Ok;
    case ResultReason::OtherType:
    case ResultReason::Unknown:
    case ResultReason::DoesNotConform:
        return ResultEvaluation::NotOk;
    case ResultReason::Inconclusive:
    case ResultReason::NotValid:
    case ResultReason::NotMeasured:
        return ResultEvaluation::NotDecidable;
    }
    return ResultEvaluation::NotDecidable;
}

bool isOverrun(JobAnswer answer)
{
    return answer == JobAnswer::ResultUnread || answer == JobAnswer::Busy;
}

namespace {

Finding reasonForRefusal(JobAnswer answer)
{
    switch (answer) {
    case JobAnswer::None:
    case JobAnswer::Taken:
        break;
    case JobAnswer::ResultUnread:
        return Words::say("the PLC has not acknowledged the result before");
    case JobAnswer::Busy:
        return Words::say("the part before is still being inspected");
    case JobAnswer::NotArmed:
        return Words::say("the gripper is not armed; a person at the station has to arm it");
    case JobAnswer::NotReady:
        return Words::say("the station is not ready; see what it says of its gripper");
    case JobAnswer::NoSuchType:
        return Words::say("no type has that number at this station; see its list of types");
    case JobAnswer::HeartbeatMissing:
        return Words::say("the heartbeat of the PLC stands still");
    case JobAnswer::OutOfStep:
        return Words::say("it is not the number that is next; the PLC has to read the last trigger that was "
                          "answered");
    }
    return {};
}

} // namespace

Finding refusalInWords(JobAnswer answer, std::uint16_t trigger, std::uint32_t partToken)
{
    return Words::say("Trigger %1 for part %2 was refused: %3.")
        .arg(trigger)
        .arg(partToken)
        .arg(reasonForRefusal(answer));
}

} // namespace gripscope
