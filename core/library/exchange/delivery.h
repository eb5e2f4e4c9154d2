// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>

namespace gripscope {

class Database;
struct ReadMeetings;

/// How much of what a station has written is at a server.
struct Delivery {
    qint64 links = 0;   ///< of its ledger, brought now
    qint64 rows = 0;    ///< that are in the server's tables since
    qint64 waiting = 0; ///< links that are still to be brought
};

/// By chain of a station's own ledger how many of its links a server has.
using DeliveredLinks = std::map<QString, qint64>;
[[nodiscard]] Expected<DeliveredLinks> deliveredLinks(Database& station, Database& server);

/// Links of a station's ledger that a server has not. The outbox of a station is its ledger: each link is
/// numbered, holds the digests of its rows and is written in the transaction of these rows; what the server
/// has of it is the mark, which needs no place of its own. StorageOpen: see newsOf().
[[nodiscard]] Expected<qint64> waitingLinks(Database& station, Database& server);

/// Brings some `most` links with their rows to the server, within its open write transaction. Again is the
/// same as once. What is in force there is worked out anew where types changed. StorageOpen: the station is
/// in step with another server, or one of the two is an older copy of itself. `read`: of the server.
[[nodiscard]] Expected<Delivery> deliver(Database& station, Database& server, qint64 most,
                                         ReadMeetings& read);

} // namespace gripscope
