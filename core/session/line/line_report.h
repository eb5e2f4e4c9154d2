// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/connect_session.h"
#include "core/session/inspect/inspect_session.h"
#include "core/session/line/clock_standing.h"
#include "core/session/line/line_values.h"

namespace gripscope {

/// A result for whoever is told of all of them, whether a key, a part or a PLC began the squeeze.
struct LineReport {
    quint64 sequence = 0; ///< counted by the station over all its runs; it alone orders reports
    QString gripper;      ///< its serial number
    QString part;         ///< its number; empty: none was given
    QString expectedType; ///< empty: none
    QString typeFound;    ///< empty: none was named
    LineResult result;    ///< its own sequence and job are of no meaning here
    std::optional<ClockStanding> clock = {}; ///< of the computer that gave it its time; nothing: unknown
    friend bool operator==(const LineReport&, const LineReport&) = default;
};

/// No part was pressed by what these addresses make.
[[nodiscard]] bool isSimulated(const QString& address);

/// Tells of each squeeze that was inspected once; recordings that are judged are none. No thread, no timer:
/// ask it right behind InspectSession::poll().
class LineReporter {
public:
    LineReporter(const ConnectSession& connection, const InspectSession& inspection);
    /// Of a squeeze that was judged since the last call.
    [[nodiscard]] std::optional<LineReport> next();
    /// The gripper that is connected, by its serial number; empty: none is.
    [[nodiscard]] QString gripper() const;

private:
    const ConnectSession& m_connection;
    const InspectSession& m_inspection;
    std::uint64_t m_told = 0;
};

} // namespace gripscope
