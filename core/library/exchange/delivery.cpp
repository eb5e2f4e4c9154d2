// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/exchange/delivery.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/merge/known_history.h"
#include "core/library/merge/meeting_table.h"
#include "core/library/merge/settlement.h"
#include "core/library/merge/taken_news.h"
#include "core/library/plant/plant_state.h"
#include "core/library/tables/audit_table.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

qint64 linksOf(const std::vector<ChainNews>& news)
{
    qint64 links = 0;
    for (const ChainNews& chain : news)
        links += chain.links - chain.after;
    return links;
}

Expected<void> requireThisServer(Database& station, Database& server)
{
    ASSIGN_OR_RETURN(const auto inStep, meeting_table::serverInStep(station));
    ASSIGN_OR_RETURN(const QString here, libraryId(server));
    if (!inStep || *inStep == here)
        return {};
    return failure(
        ErrorCode::StorageOpen,
        {station.file(), Words::tr("it has taken types from another server's library than %1, which it "
                                   "would have to be brought in step with")
                             .arg(server.file())});
}

/// The delivery is on record, with the ends of the chains that came: a shorter one is known by it. Where
/// types changed, whoever changes them here from now on has seen them.
Expected<void> record(Database& station, Database& server, const std::vector<ChainNews>& news,
                      const TakenRows& taken)
{
    ASSIGN_OR_RETURN(const QString other, libraryId(station));
    ASSIGN_OR_RETURN(Meeting meeting, meetingOf(other, server, taken.sum(), {}));
    if (taken.hasChanges) {
        ASSIGN_OR_RETURN(meeting.seen, seenVersions(server));
    }
    for (const ChainNews& chain : news) {
        ASSIGN_OR_RETURN(const ChainEnd end, merged_ledger::endOf(server, {chain.library, chain.chain}));
        meeting.addHead(chain.library, end);
    }
    return meeting_table::insert(server, meeting);
}

} // namespace

Expected<DeliveredLinks> deliveredLinks(Database& station, Database& server)
{
    DeliveredLinks links;
    ASSIGN_OR_RETURN(const QString library, libraryId(station));
    ASSIGN_OR_RETURN(const auto own, ledger_table::ends(station));
    for (const auto& [chain, end] : own) {
        ASSIGN_OR_RETURN(const ChainEnd there, merged_ledger::endOf(server, {library, chain}));
        links[chain] = there.links;
    }
    return links;
}

Expected<qint64> waitingLinks(Database& station, Database& server)
{
    return newsOf(station, server).map(linksOf);
}

Expected<Delivery> deliver(Database& station, Database& server, qint64 most, ReadMeetings& read)
{
    ASSIGN_OR_RETURN(const auto oneState,
                     ReadTransaction::begin(station, Words::tr("be brought to the server")));
    RETURN_IF_ERROR(requireThisServer(station, server));
    ASSIGN_OR_RETURN(const auto all, newsOf(station, server));
    const std::vector<ChainNews> news = firstOf(all, most);
    Delivery delivery;
    ASSIGN_OR_RETURN(const TakenNews taken, takeNews(station, server, news));
    if (taken.rows.hasChanges) {
        ASSIGN_OR_RETURN(const PlantHistory history, knownHistory(server, read));
        ASSIGN_OR_RETURN(const qint64 version, settle(server, plantState(history), station.file(), {}));
        const QJsonObject details{{u"rows"_s, taken.rows.sum()}, {u"version"_s, version}};
        RETURN_IF_ERROR(audit_table::append(
            server, {QString::fromUtf16(audit_action::libraryMerged), station.file(), {}, details, {}}));
    }
    if (taken.rows.sum() > 0)
        RETURN_IF_ERROR(record(station, server, news, taken.rows));
    delivery.links = taken.links;
    delivery.rows = taken.rows.sum();
    delivery.waiting = linksOf(all) - taken.links;
    return delivery;
}

} // namespace gripscope
