// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/line_session.h"

#include "core/base/words.h"
#include "core/recognition/verdict/conformity_of_squeeze.h"
#include "core/session/line/line_report.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A PLC that is refused a thousand times tells a person nothing new.
constexpr std::size_t mostNews = 16;

ResultReason reasonOf(InspectionOutcome outcome)
{
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return ResultReason::AsExpected;
    case InspectionOutcome::OtherType:
        return ResultReason::OtherType;
    case InspectionOutcome::Unknown:
        return ResultReason::Unknown;
    case InspectionOutcome::Inconclusive:
        return ResultReason::Inconclusive;
    case InspectionOutcome::NotValid:
        return ResultReason::NotValid;
    case InspectionOutcome::DoesNotConform:
        return ResultReason::DoesNotConform;
    }
    return ResultReason::NotMeasured;
}

std::array<std::optional<LineQuantity>, 3> quantitiesOf(const InspectSession::Result& result)
{
    std::array<std::optional<LineQuantity>, 3> quantities;
    const std::optional<double> toSi = siFactor(result.recording.forceUnit, result.recording.positionUnit);
    if (!toSi)
        return quantities;
    const MeasuredValues measured = measuredValues(result.identification, *toSi);
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        if (!measured[i] || !std::isfinite(measured[i]->value))
            continue;
        quantities[i] = LineQuantity{measured[i]->value, measured[i]->standardUncertainty};
        if (const auto& u = quantities[i]->standardUncertainty; u && !std::isfinite(*u))
            quantities[i]->standardUncertainty.reset();
    }
    return quantities;
}

} // namespace

LineResult lineResult(const InspectSession::Result& result, const QStringList& types)
{
    LineResult told;
    told.state = ResultState::Completed;
    told.reason = reasonOf(result.outcome);
    told.evaluation = evaluationOf(told.reason);
    if (result.verdict.kind == VerdictKind::Type)
        told.typeFound = static_cast<std::uint16_t>(types.indexOf(result.verdict.type) + 1);
    told.quantities = quantitiesOf(result);
    told.utc = QDateTime::currentDateTimeUtc();
    return told;
}

LineSession::LineSession(ConnectSession& connection, InspectSession& inspection,
                         std::shared_ptr<SharedJobDesk> desk)
    : m_connection(connection), m_inspection(inspection), m_desk(std::move(desk))
{
}

LineState LineSession::stationState() const
{
    if (m_connection.stopState() == StopState::NotObeyed ||
        m_inspection.unstored() >= InspectSession::mostUnstored)
        return LineState::Error;
    if (m_connection.state() != ConnectSession::State::Connected ||
        m_inspection.state() == InspectSession::State::Loading)
        return LineState::Preoperational;
    if (m_occupied || m_inspection.state() != InspectSession::State::Ready)
        return LineState::SingleExecution;
    if (m_connection.armed())
        return LineState::Ready;
    return m_halted || m_connection.stopState() != StopState::None ? LineState::Halted
                                                                   : LineState::Initialized;
}

JobDesk::Station LineSession::station() const
{
    return {stationState(), m_connection.armed(), isSimulated(m_connection.address()),
            static_cast<std::uint16_t>(std::min<qsizetype>(m_types.size(), 65535))};
}

void LineSession::poll(TimePoint now)
{
    if (m_connection.armed())
        m_halted = false;
    watchHeartbeat(now);
    follow(now);
    const JobDesk::Station current = station();
    const bool beats = now - m_beatAt >= beatEvery;
    if (beats)
        m_beatAt = now;
    std::vector<JobDesk::Refusal> refusals;
    const std::optional<LineJob> job = m_desk->with([&](JobDesk& desk) {
        desk.setStation(current);
        if (beats)
            desk.stationBeats();
        refusals = desk.takeRefusals();
        return desk.takeJob();
    });
    for (const JobDesk::Refusal& refusal : refusals)
        tell(refusalInWords(refusal.answer, refusal.job.trigger, refusal.job.partToken));
    if (job)
        begin(*job, now);
}

void LineSession::watchHeartbeat(TimePoint now)
{
    const bool lost = m_desk->with([now](JobDesk& desk) { return desk.takeLostHeartbeat(now); });
    if (!lost)
        return;
    if (!m_connection.armed())
        return tell(Words::say("The heartbeat of the PLC stands still."));
    m_connection.stop();
    m_connection.disarm();
    m_halted = true;
    tell(Words::say("The heartbeat of the PLC stands still. The gripper was stopped and disarmed; arm it "
                    "again when the PLC is back."));
}

void LineSession::begin(const LineJob& job, TimePoint now)
{
    m_job = job;
    m_partNumberBefore = m_inspection.partNumber();
    const QString expected = m_inspection.expectedType();
    if (job.type > 0 && job.type <= m_types.size())
        m_inspection.setExpectedType(m_types[job.type - 1]);
    m_inspection.setPartNumber(QString::number(job.partToken));
    const Expected<void> begun = m_inspection.squeeze();
    m_inspection.setExpectedType(expected); // what a squeeze began with is its own
    m_inspection.setPartNumber(m_partNumberBefore);
    if (!begun)
        fail(begun.error(), now);
}

void LineSession::follow(TimePoint now)
{
    if (!m_job || m_inspection.state() == InspectSession::State::Squeezing ||
        m_inspection.state() == InspectSession::State::Judging)
        return;
    const auto& result = m_inspection.result();
    // A squeeze that somebody began before this was looked at has another part's number.
    if (!result || result->partNumber != QString::number(m_job->partToken))
        return fail(m_inspection.lastError(), now);
    LineResult told = lineResult(*result, m_types);
    told.simulated = isSimulated(m_connection.address());
    m_job.reset();
    m_desk->with([&](JobDesk& desk) { desk.finish(std::move(told), now); });
}

void LineSession::fail(const std::optional<Error>& error, TimePoint now)
{
    const bool aborted = error && (error->code == ErrorCode::Cancelled || error->code == ErrorCode::Stopped);
    LineResult told;
    told.state = aborted ? ResultState::Aborted : ResultState::Failed;
    told.reason = ResultReason::NotMeasured;
    told.evaluation = evaluationOf(told.reason);
    told.partial = true;
    told.simulated = isSimulated(m_connection.address());
    told.utc = QDateTime::currentDateTimeUtc();
    m_inspection.setPartNumber(m_partNumberBefore); // the PLC decides what becomes of its part
    tell(Words::say("Part %1 was not inspected: %2")
             .arg(m_job->partToken)
             .arg(error ? Finding(error->describe()) : Words::say("its squeeze did not come to its end.")));
    m_job.reset();
    m_desk->with([&](JobDesk& desk) { desk.finish(std::move(told), now); });
}

void LineSession::tell(const Finding& news)
{
    m_news.push_back(news);
    if (m_news.size() > mostNews)
        m_news.erase(m_news.begin());
}

Findings LineSession::takeNews()
{
    return std::exchange(m_news, {});
}

} // namespace gripscope
