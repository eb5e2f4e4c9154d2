// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/ledger_link.h"

#include <QStringList>

namespace gripscope {

/// What is wrong with a link behind the one that its chain ended with, in words: its number, what it follows
/// from, its hash, its signature.
[[nodiscard]] QStringList problemsOf(const LedgerLink& link, const LedgerHead& before);

} // namespace gripscope
