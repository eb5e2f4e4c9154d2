// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/exchange/delivery.h"

#include <deque>
#include <map>
#include <utility>

namespace gripscope {

/// What a station has written and its server has not.
struct Waiting {
    qint64 links = 0;       ///< of its ledger
    qint64 inspections = 0; ///< in them
    friend bool operator==(const Waiting&, const Waiting&) = default;
};

/// Counts what waits for a server, each link of the ledger read once. For one library.
class WaitingCount {
public:
    /// `delivered`: what the server has, as far as is known.
    [[nodiscard]] Expected<Waiting> count(Database& station, const DeliveredLinks& delivered);

private:
    struct Chain {
        qint64 mark = 0;                                   ///< links at the server
        qint64 counted = 0;                                ///< links that were read, or are at the server
        std::deque<std::pair<qint64, qint64>> withResults; ///< link, its inspections; those that wait
    };
    [[nodiscard]] static Expected<void> countOn(Database& station, const QString& name, qint64 last,
                                                Chain& chain);
    std::map<QString, Chain> m_chains;
};

} // namespace gripscope
