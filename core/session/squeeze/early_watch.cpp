// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/early_watch.h"

#include "core/session/squeeze/squeeze_job.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gripscope {

namespace {

/// Beyond so many in a row the record is of no use to a test, and memory has its limits.
constexpr std::uint64_t mostLostInARow = 10'000;

} // namespace

/// What the pool works on; only one task at a time, and nobody else looks.
struct EarlyWatch::Followed {
    EarlyStopSetup setup;
    std::optional<EarlyStop> stop = {}; ///< made by the first task: it predicts every type

    std::optional<EarlyEnd> look(const std::vector<Pair>& pairs)
    {
        if (!stop)
            stop.emplace(setup);
        bool due = false;
        for (const Pair& pair : pairs)
            due = stop->add(pair.force, pair.position) || due;
        return due ? stop->look() : std::nullopt;
    }
};

void EarlyWatch::begin(EarlyStopSetup setup, std::size_t samples)
{
    end();
    m_taken = 0;
    m_worthLooking = samples - samples / 10;
    m_followed = std::make_shared<Followed>(Followed{std::move(setup)});
}

void EarlyWatch::end()
{
    m_task.forget();
    m_followed.reset();
    m_waiting.clear();
    m_lastSequence.reset();
    m_decision.reset(); // else it would end the next squeeze, too, where that is not followed
}

void EarlyWatch::take(const std::vector<Sample>& batch)
{
    if (!m_followed || m_decision)
        return;
    for (const Sample& sample : batch)
        if (sample.status & StatusMoving)
            take(sample);
}

void EarlyWatch::take(const Sample& sample)
{
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (m_lastSequence && sample.sequence > *m_lastSequence + 1) {
        const std::uint64_t lost = std::min(sample.sequence - *m_lastSequence - 1, mostLostInARow);
        m_waiting.insert(m_waiting.end(), static_cast<std::size_t>(lost), Pair{nothing, nothing});
    }
    m_lastSequence = sample.sequence;
    ++m_taken;
    const bool atLimit = sample.status & (StatusForceSaturated | StatusPositionSaturated);
    m_waiting.push_back(atLimit ? Pair{nothing, nothing} : Pair{sample.force, sample.position});
}

void EarlyWatch::poll()
{
    if (!m_followed || m_decision)
        return;
    if (m_task.waiting()) {
        std::optional<std::optional<EarlyEnd>> looked = m_task.take();
        if (!looked)
            return;
        m_decision = *looked;
        if (m_decision) {
            m_waiting.clear();
            return;
        }
    }
    if (m_waiting.empty() || m_taken > m_worthLooking)
        return;
    m_task = inPool(
        [followed = m_followed, pairs = std::exchange(m_waiting, {})] { return followed->look(pairs); });
}

void SqueezeForecast::ask(const EarlyStopSetup& setup, const Recipe& recipe)
{
    const Question question{setup, recipe};
    if (m_question == question)
        return;
    m_times.reset();
    m_question = question;
    GripperIdentity identity;
    identity.sampleTime_s = setup.decision.sampleTime_s;
    m_task =
        inPool([setup, excitation = excitationOptions(recipe, identity, 1)]() -> std::optional<EarlyTimes> {
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
