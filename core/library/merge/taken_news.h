// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/merge/library_news.h"
#include "core/library/merge/row_taker.h"

namespace gripscope {

/// What came of links that were new.
struct TakenNews {
    TakenRows rows;
    qint64 links = 0;
};

/// Brings the rows of these links in, and the links themselves as they are, within the open write
/// transaction. What is in force is not worked out (settle()). UnitsDiffer: its types cannot be compared with
/// those that are there. StorageCorrupt: a row is not what its ledger says.
[[nodiscard]] Expected<TakenNews> takeNews(Database& source, Database& target,
                                           const std::vector<ChainNews>& news);

/// UnitsDiffer: the types of the two cannot be compared with each other.
[[nodiscard]] Expected<void> requireComparableTypes(Database& source, Database& target);

} // namespace gripscope
