// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect/inspect_session.h"
#include "core/session/line/job_desk.h"

#include <QStringList>

namespace gripscope {

/// What a result says of an inspection: outcome and m, b, k in SI with their standard uncertainties. Without
/// known units these are not told. `types`: by number, the first is 1.
[[nodiscard]] LineResult lineResult(const InspectSession::Result& result, const QStringList& types);

/// Inspects on the jobs of a desk, by the session that a key drives as well: recipe, limits and safety gate
/// are the same, and so is who may arm. A job cannot arm; a PLC whose heartbeat ends stops and disarms the
/// gripper. The part token is the inspection's part number. No thread, no timer: poll() it right behind
/// ConnectSession::poll() and InspectSession::poll().
class LineSession {
public:
    using TimePoint = JobDesk::TimePoint;
    static constexpr std::chrono::milliseconds beatEvery{100};

    LineSession(ConnectSession& connection, InspectSession& inspection, std::shared_ptr<SharedJobDesk> desk);

    void setTypes(const QStringList& byNumber) { m_types = byNumber; }
    /// Another than this line squeezes (an enrolment, a study): jobs are refused as Busy.
    void setOccupied(bool occupied) { m_occupied = occupied; }
    void poll(TimePoint now = std::chrono::steady_clock::now());

    [[nodiscard]] bool working() const { return m_job.has_value(); }
    /// What a person is to be told, since the last call: refused triggers, a lost PLC. Bounded.
    [[nodiscard]] Findings takeNews();

private:
    [[nodiscard]] LineState stationState() const;
    [[nodiscard]] JobDesk::Station station() const;
    void watchHeartbeat(TimePoint now);
    void begin(const LineJob& job, TimePoint now);
    void follow(TimePoint now);
    void fail(const std::optional<Error>& error, TimePoint now);
    void tell(const Finding& news);

    ConnectSession& m_connection;
    InspectSession& m_inspection;
    std::shared_ptr<SharedJobDesk> m_desk;
    QStringList m_types;
    bool m_occupied = false, m_halted = false;
    std::optional<LineJob> m_job;
    QString m_partNumberBefore; ///< a person's, for the next part that is squeezed by hand
    TimePoint m_beatAt;
    Findings m_news;
};

} // namespace gripscope
