// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"

namespace gripscope {

/// A place on the way through a history by time.
struct HistoryMark {
    qint64 row = 0;    ///< so many rows of the list are there or before
    QString time, key; ///< of the squeeze there, as they are stored; empty: where the way begins
};

/// What a query finds, as a list any part of which can be read by itself (Library::historyPage()), so that
/// the first page of ten million comes as soon as that of a hundred.
///
/// Up to mostCollected squeezes the list knows all keys, in the order asked for. Of more it depends:
/// - By time an index leads through them: the list is walked, a page being read from the mark before it. How
///   many there are is known at once where the tallies of inspections know the filter (kind, outcome, type,
///   expected type); else the list is gone through stretch by stretch (Library::historyStretch()), and until
///   that has come to its end there are at least `rows`. Each stretch leaves a mark.
/// - By any other column no index leads through them, and one for each would cost every inspection its time:
///   the newest mostCollected are in it, in that order (by number upwards: the oldest). It is cut then, and
///   who shows it says so; dates and other filters bring the rest into reach.
///
/// What is stored after it was made is not in it.
struct HistoryList {
    static constexpr std::size_t mostCollected = 20'000;
    /// Squeezes of the library that a stretch goes through, found or not: a tenth of a second at the most.
    static constexpr int stretch = 20'000;
    /// Where nothing is left out: the way is along the index alone.
    static constexpr int openStretch = 50'000;

    HistoryQuery query;
    HistoryKeys keys; ///< of all rows, in order; none where it is walked
    bool walked = false, cut = false;
    qint64 rows = 0;
    HistoryCounts counts; ///< of all that is found, rows or not; of those known so far unless `counted`
    bool counted = true;
    bool through = true; ///< false: there is a further stretch
    HistoryMark newest;  ///< of the library when the list was made; empty: it held nothing
    qint64 stored =
        0; ///< the place of the squeeze that was stored last then: later ones may be of earlier times
    std::vector<HistoryMark> marks = {};
    HistoryCounts passed = {}; ///< of the stretches so far

    /// In which direction of time it is gone through.
    [[nodiscard]] bool backwards() const { return cut || query.descending; }
};

} // namespace gripscope
