// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/lag_session.h"

#include "core/signal/preparation.h"
#include "core/words.h"

namespace gripscope {

LagSession::LagSession(ConnectSession& connection, LibraryService& library)
    : JudgedSeries(connection, library)
{
}

Expected<void> LagSession::start(const Recipe& recipe, int squeezes)
{
    return begin(recipe, squeezes);
}

void LagSession::clear()
{
    JudgedSeries::clear();
    m_result = {};
}

void LagSession::judge(const Recording& recording)
{
    judgeBy(estimateLag, recording);
}

void LagSession::conclude()
{
    m_result = combineLags(squeezes());
}

Expected<void> LagSession::accept()
{
    if (state() != State::Measured || m_result.status != LagStatus::Measured)
        return failure(ErrorCode::Usage,
                       {Words::tr("There is no lag that was measured well enough to be used.")});
    MeasuringChain chain = connection().measuringChain();
    chain.forceLagUncertainty_s = m_result.standardError_s;
    return storeChain({serial(), m_result.lag_s, chain, operatorName(),
                       Words::tr("lag from %1 squeezes").arg(m_result.squeezes)});
}

LagEstimate estimateLag(const Recording& recording)
{
    const PreparedRecord record = prepare(recording);
    LagEstimationOptions options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = record.hold.value_or(ForceHold::First);
    options.holdIsKnown = record.hold.has_value();
    options.expectedLag_s = record.forceLag_s;
    options.lost = record.lost;
    return estimateLag(record.force, record.position, options);
}

} // namespace gripscope
