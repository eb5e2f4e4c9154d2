// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/line/job_desk.h"

namespace gripscope {

/// What is known of the wire to the PLC.
struct LineLink {
    bool on = false;             ///< switched on
    QString listening;           ///< "127.0.0.1:1502"; empty: not yet, or not at all
    std::optional<Error> failed; ///< why not
    int clients = 0;
    QDateTime clientsChanged; ///< when the first came or the last went; before: when listening began
    QString refusedPeer;      ///< the last address that was turned away; empty: none was
    std::uint64_t requests = 0, malformed = 0;
    friend bool operator==(const LineLink&, const LineLink&) = default;
};

/// How the line is told, the same wherever it shows.
struct LineWords {
    Finding headline;  ///< "PLC: in step"
    Findings problems; ///< a sentence each: what is wrong, and what to do
    bool well = false;
};
/// An unread result is a problem from `patience` on.
[[nodiscard]] LineWords lineWords(const LineLink& link, const JobDesk::View& view, JobDesk::TimePoint now,
                                  std::chrono::milliseconds patience = std::chrono::seconds(5));

} // namespace gripscope
