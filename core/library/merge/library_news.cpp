// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/library_news.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/sql/database.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What one library knows of ledgers.
struct KnownChains {
    Database& database;
    QString own; ///< libraryId()

    [[nodiscard]] static Expected<KnownChains> of(Database& database)
    {
        ASSIGN_OR_RETURN(const QString own, libraryId(database));
        return KnownChains{database, own};
    }
    [[nodiscard]] Expected<std::map<merged_ledger::LibraryChain, ChainEnd>> ends() const
    {
        ASSIGN_OR_RETURN(auto ends, merged_ledger::ends(database));
        ASSIGN_OR_RETURN(const auto ownEnds, ledger_table::ends(database));
        for (const auto& [chain, end] : ownEnds)
            ends[{own, chain}] = end;
        return ends;
    }
    /// Of one chain, however many there are.
    [[nodiscard]] Expected<qint64> linksOf(const merged_ledger::LibraryChain& chain) const
    {
        if (chain.first == own)
            return ledger_table::head(database, chain.second).map(&LedgerHead::links);
        return merged_ledger::endOf(database, chain).map(&ChainEnd::links);
    }
    [[nodiscard]] Expected<QByteArray> hashOf(const merged_ledger::LibraryChain& chain, qint64 number) const
    {
        return chain.first == own ? ledger_table::hashOf(database, chain.second, number)
                                  : merged_ledger::hashOf(database, chain, number);
    }
};

tl::unexpected<Error> refuse(const KnownChains& there, const QString& why)
{
    return failure(ErrorCode::StorageOpen, {there.database.file(), why});
}

/// Why two libraries that know a chain differently, or go on with it both, cannot be brought together.
tl::unexpected<Error> refuseCopies(const KnownChains& here, const KnownChains& there,
                                   const merged_ledger::LibraryChain& chain)
{
    if (there.own == here.own)
        return refuse(there,
                      Words::tr("it is a copy of this library that was gone on with. Go on with one of "
                                "them alone: keep the other aside, or put it back with \"library restore\""));
    if (chain.first == here.own)
        return refuse(there, Words::tr("it has met a newer state of this library: an older copy was put back "
                                       "here. Put back the newest copy there is, then merge"));
    return refuse(
        there, Words::tr("the two know the ledger of a library differently, by chain %1: one of them has "
                         "met a copy of it that was gone on with. Find out which station works with a copy, "
                         "and put back its newest library there")
                   .arg(chain.second));
}

} // namespace

Expected<std::vector<ChainNews>> newsOf(Database& source, Database& target)
{
    ASSIGN_OR_RETURN(const KnownChains there, KnownChains::of(source));
    ASSIGN_OR_RETURN(const KnownChains here, KnownChains::of(target));
    ASSIGN_OR_RETURN(const auto ends, there.ends());
    std::vector<ChainNews> news;
    for (const auto& [chain, end] : ends) {
        ASSIGN_OR_RETURN(const qint64 links, here.linksOf(chain));
        const qint64 common = std::min(links, end.links);
        if (common > 0) {
            ASSIGN_OR_RETURN(const QByteArray one, there.hashOf(chain, common));
            ASSIGN_OR_RETURN(const QByteArray other, here.hashOf(chain, common));
            if (one != other)
                return refuseCopies(here, there, chain);
        }
        if (end.links <= links)
            continue;
        if (chain.first == here.own)
            return refuseCopies(here, there, chain);
        news.push_back({chain.first, chain.second, links, end.links});
    }
    std::stable_partition(news.begin(), news.end(),
                          [&](const ChainNews& one) { return one.library != there.own; });
    return news;
}

std::vector<ChainNews> firstOf(std::vector<ChainNews> news, qint64 most)
{
    if (news.size() == 1)
        news.front().links = std::min(news.front().links, news.front().after + most);
    return news;
}

Expected<void> forEachLink(Database& source, const ChainNews& news,
                           const std::function<void(const LedgerLink&)>& take)
{
    ASSIGN_OR_RETURN(const QString own, libraryId(source));
    return news.library == own
               ? ledger_table::since(source, news.chain, news.after, news.links, take)
               : merged_ledger::since(source, {news.library, news.chain}, news.after, news.links, take);
}

} // namespace gripscope
