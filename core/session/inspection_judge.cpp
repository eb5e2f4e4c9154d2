// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspection_judge.h"

#include "core/recognition/judgement.h"
#include "core/signal/units.h"

namespace gripscope {

Expected<void> InspectionJudge::start(Recording recording, const ComparableTypes& types)
{
    const Expected<ComparableTypes::Choice> choice =
        types.modelsFor(recording.forceUnit, recording.positionUnit);
    if (!choice)
        return tl::unexpected<Error>(choice.error());
    IdentificationOptions withEarlier = identification;
    withEarlier.earlierHold = m_holds.before(recording, identification);
    m_ratesThen = rates;
    m_ratesThen.siUnits = siFactor(recording.forceUnit, recording.positionUnit).has_value();
    m_measured = recording;
    m_task.start([recording = std::move(recording), withEarlier, judging = m_ratesThen, other = transfer,
                  models = choice->models, factor = choice->factor] {
        Found found{identify(recording, withEarlier), {}};
        found.verdict = judge(*models, found.identification, factor, judging, other);
        return found;
    });
    return {};
}

std::optional<InspectionJudge::Judged> InspectionJudge::take()
{
    std::optional<Found> found = m_task.take();
    if (!found)
        return {};
    m_holds.add(m_measured, found->identification);
    return Judged{std::move(m_measured), std::move(found->identification), std::move(found->verdict),
                  m_ratesThen};
}

} // namespace gripscope
