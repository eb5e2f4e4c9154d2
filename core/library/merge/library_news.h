// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/ledger_link.h"

#include <functional>
#include <vector>

namespace gripscope {

class Database;

/// Links that a library has, of its own ledger or of one that it has met, and that this one has not: the mark
/// from which on a chain is to be brought is its number of links here.
struct ChainNews {
    QString library, chain;
    qint64 after = 0; ///< links that are here
    qint64 links = 0; ///< links there
};

/// Those of libraries that the other has met come first, its own last. StorageOpen: the two know the same
/// chain differently, since one of them, or one that they met, is a copy that was gone on with; what to do is
/// said.
[[nodiscard]] Expected<std::vector<ChainNews>> newsOf(Database& source, Database& target);

/// As many links as `most` where all are of one chain. Rows of one may point to those of another: several
/// come whole.
[[nodiscard]] std::vector<ChainNews> firstOf(std::vector<ChainNews> news, qint64 most);

[[nodiscard]] Expected<void> forEachLink(Database& source, const ChainNews& news,
                                         const std::function<void(const LedgerLink&)>& take);

} // namespace gripscope
