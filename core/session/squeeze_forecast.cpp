// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze_forecast.h"

#include "core/session/squeeze_job.h"

namespace gripscope {

void SqueezeForecast::ask(const EarlyStopSetup& setup, const Recipe& recipe)
{
    const Question question{setup, recipe};
    if (m_question == question)
        return;
    m_times.reset();
    m_question = question;
    GripperIdentity identity;
    identity.sampleTime_s = setup.decision.sampleTime_s;
    m_task.start([setup, excitation = excitationOptions(recipe, identity, 1)]() -> std::optional<EarlyTimes> {
        const Expected<std::vector<double>> force = makeExcitation(excitation);
        return force ? expectedTimes(setup, *force) : std::nullopt;
    });
}

void SqueezeForecast::forget()
{
    m_question.reset();
    m_times.reset();
    m_task.forget();
}

bool SqueezeForecast::poll()
{
    std::optional<std::optional<EarlyTimes>> answer = m_task.take();
    if (!answer)
        return false;
    m_times = *answer;
    return true;
}

} // namespace gripscope
