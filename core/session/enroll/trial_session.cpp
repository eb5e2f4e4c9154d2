// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/enroll/trial_session.h"

#include "core/identification/identification.h"
#include "core/session/tasks/pool.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <utility>

namespace gripscope {

Expected<ComparableTypes> typesWith(Library& library, const QString& type)
{
    ASSIGN_OR_RETURN(std::vector<TypeRecord> types, library.types());
    ASSIGN_OR_RETURN(std::vector<TypeSqueeze> squeezes, library.enrolledSqueezes());
    std::erase_if(types, [&](const TypeRecord& one) { return !one.approved && one.name != type; });
    std::erase_if(squeezes, [&](const TypeSqueeze& squeeze) {
        return std::none_of(types.begin(), types.end(),
                            [&](const TypeRecord& one) { return one.name == squeeze.type; });
    });
    return ComparableTypes(types, squeezes);
}

TrialSession::TrialSession(ConnectSession& connection, LibraryService& library)
    : SeriesSession(connection, library), m_library(library)
{
}

Expected<void> TrialSession::start(const QString& type, const Recipe& recipe, const VerdictOptions& rates)
{
    RETURN_IF_ERROR(begin(recipe, 1)); // one that is under way goes on as it was begun
    m_type = type;
    m_rates = rates;
    return {};
}

void TrialSession::clear()
{
    forgetJudging();
    m_verdict.reset();
}

void TrialSession::judge(const Recording& recording)
{
    m_recording = recording;
    m_types = m_library.run<ComparableTypes>(
        [type = m_type](Library& library) { return typesWith(library, type); });
}

Expected<void> TrialSession::judgeBy(const ComparableTypes& types)
{
    ASSIGN_OR_RETURN(const ComparableTypes::Choice choice,
                     types.modelsFor(m_recording.forceUnit, m_recording.positionUnit));
    VerdictOptions rates = m_rates;
    rates.siUnits = siFactor(m_recording.forceUnit, m_recording.positionUnit).has_value();
    m_task = inPool([recording = std::exchange(m_recording, {}), choice, rates] {
        return judgeRecording(*choice.types, identify(recording), recording, rates);
    });
    return {};
}

bool TrialSession::takeJudged()
{
    if (const std::optional<Expected<ComparableTypes>> types = m_types.take()) {
        const Expected<void> begun =
            types->and_then([this](const ComparableTypes& known) { return judgeBy(known); });
        if (!begun) {
            fail(begun.error());
            return false;
        }
    }
    std::optional<Verdict> found = m_task.take();
    if (!found)
        return false;
    m_verdict = *std::move(found);
    return true;
}

void TrialSession::forgetJudging()
{
    m_types.forget();
    m_task.forget();
}

} // namespace gripscope
