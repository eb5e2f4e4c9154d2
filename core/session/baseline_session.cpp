// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/baseline_session.h"

#include "core/session/squeeze_obstacle.h"
#include "core/words.h"

namespace gripscope {

BaselineSession::BaselineSession(ConnectSession& connection, LibraryService& library)
    : SeriesSession(connection, library)
{
}

Expected<void> BaselineSession::start(const Recipe& recipe, int squeezes)
{
    return begin(recipe, squeezes);
}

void BaselineSession::clear()
{
    m_squeezes.clear();
    m_baseline.reset();
    m_problem.clear();
}

void BaselineSession::judge(const Recording& recording)
{
    Recording whole = recording;
    whole.chain.baseline.reset(); // it is the empty gripper itself that is looked for
    m_task.start(std::move(whole), {});
}

bool BaselineSession::takeJudged()
{
    std::optional<Identification> found = m_task.take();
    if (found)
        m_squeezes.push_back(std::move(*found));
    return found.has_value();
}

void BaselineSession::forgetJudging()
{
    m_task.forget();
}

void BaselineSession::conclude()
{
    m_problem = obstacleOf(m_squeezes);
    if (!m_problem.isEmpty())
        return;
    const std::optional<RepeatedMeasurement> found = repeatedMeasurement(m_squeezes);
    if (!found) {
        m_problem = Words::tr("no m, b and k above zero were found with their uncertainty");
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
                       Words::tr("empty gripper, %1 squeezes").arg(m_squeezes.size())});
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
