// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/exchange/library_exchange.h"

#include "core/base/words.h"
#include "core/library/exchange/waiting_count.h"
#include "core/library/library_private.h"
#include "core/library/merge/library_merge.h"

namespace gripscope {

Expected<ExchangeStep> Library::exchangeWith(Library& server, const QString& marks, qint64 mostLinks)
{
    Database& here = *d->database;
    Database& there = *server.d->database;
    ExchangeStep step;
    step.marks = marks;
    ASSIGN_OR_RETURN(const qint64 delivered, version()); // before it is asked what waits: it is there then
    ASSIGN_OR_RETURN(const qint64 waiting, waitingLinks(here, there));
    if (waiting > 0) {
        const auto brought = server.d->write<Delivery>(Words::tr("take what a station has written"), [&] {
            return deliver(here, there, mostLinks, server.d->meetings);
        });
        if (!brought) {
            server.d->meetings = {}; // it may have read what is not there now
            return tl::unexpected(brought.error());
        }
        step.delivered = *brought;
    }
    if (waiting > 0 || marks.isEmpty()) {
        ASSIGN_OR_RETURN(step.there, deliveredLinks(here, there));
    }
    if (step.delivered.waiting > 0)
        return step;
    ASSIGN_OR_RETURN(const QString now, marksOf(there));
    step.inStep = now == marks;
    if (step.inStep)
        return step;
    ASSIGN_OR_RETURN(const ServerTypes types, readServerTypes(there, here));
    if (types.anyNew()) {
        ASSIGN_OR_RETURN(step.fetched, d->write<FetchedTypes>(Words::tr("take the types of the server"), [&] {
            return takeServerTypes(types, here, delivered);
        }));
    }
    if (step.fetched.isLate)
        return step;
    step.marks = now;
    step.inStep = step.fetched.rows == 0; // else what came is told to the server first
    ASSIGN_OR_RETURN(step.conflicts, server.conflicts());
    return step;
}

Expected<Waiting> Library::countWaiting(WaitingCount& count, const DeliveredLinks& delivered) const
{
    return count.count(*d->database, delivered);
}

} // namespace gripscope
