// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/ledger_link.h"

#include <QStringList>

// What verifyLibrary() consists of.

namespace gripscope {

class Database;
struct LibraryVerification;
struct LibraryWitness;

/// Each chain from its first link: numbers without a hole, each hash what it is of, each link behind the one
/// before, signed by the key that its chain is named after; every leaf against its row, every row against the
/// leaves; and each chain against what the second place knows.
void checkLedger(Database& database, const LibraryWitness& witness, LibraryVerification& found);

/// What is wrong with a link behind the one that its chain ended with, in words: its number, what it follows
/// from, its hash, its signature.
[[nodiscard]] QStringList problemsOf(const LedgerLink& link, const LedgerHead& before);

/// The ledgers of libraries that were merged into this one: each chain by itself, each row as its station had
/// it, and that none ends before it did when it was merged.
void checkMerged(Database& database, LibraryVerification& found);

/// What follows from something else is worked out again: each recording is unpacked and held against its own
/// SHA-256, the pictures and the recordings of enrolments under way likewise, and the estimate that stands
/// for a squeeze is made anew from its recording. The estimate may differ by a standard error: the squeezes
/// of a session tell together how a gripper holds its force, and a later program may estimate a little
/// better. Takes as long as identifying all of them.
void recompute(Database& database, LibraryVerification& found);

} // namespace gripscope
