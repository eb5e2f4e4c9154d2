// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/baseline_session.h"

#include "core/session/measured_together.h"
#include "core/words.h"

namespace gripscope {

BaselineSession::BaselineSession(ConnectSession& connection, LibraryService& library)
    : JudgedSeries(connection, library)
{
}

Expected<void> BaselineSession::start(const Recipe& recipe, int squeezes)
{
    return begin(recipe, squeezes);
}

void BaselineSession::clear()
{
    JudgedSeries::clear();
    m_baseline.reset();
    m_problem.clear();
}

void BaselineSession::judge(const Recording& recording)
{
    Recording whole = recording;
    whole.chain.baseline.reset(); // it is the empty gripper itself that is looked for
    judgeBy([](const Recording& one) { return identify(one); }, std::move(whole));
}

void BaselineSession::conclude()
{
    const auto found = measuredTogether(squeezes());
    if (!found) {
        m_problem = found.error();
        return;
    }
    const MassDampingStiffness& own = found->parameters;
    m_baseline = GripperBaseline{{own.m, own.b, own.k}, found->ownErrors};
}

Expected<void> BaselineSession::accept()
{
    if (state() != State::Measured || !m_baseline)
        return failure(ErrorCode::Usage,
                       {Words::tr("There is no baseline that was measured well enough to be used.")});
    MeasuringChain chain = connection().measuringChain();
    chain.baseline = m_baseline;
    return storeChain({serial(), connection().forceLag_s(), chain, operatorName(),
                       Words::tr("empty gripper, %1 squeezes").arg(squeezes().size())});
}

Expected<void> BaselineSession::remove()
{
    if (busy() || !connection().measuringChain().baseline)
        return failure(ErrorCode::Usage, {Words::tr("There is no baseline that could be taken away now.")});
    clear();
    MeasuringChain chain = connection().measuringChain();
    chain.baseline.reset();
    return storeChain({connection().identity().serial, connection().forceLag_s(), chain, operatorName(),
                       Words::tr("the empty gripper is no longer taken off")});
}

} // namespace gripscope
