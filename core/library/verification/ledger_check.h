// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

class Database;
struct LibraryVerification;
struct LibraryWitness;

/// Each chain from its first link: numbers without a hole, each hash what it is of, each link behind the one
/// before, signed by the key that its chain is named after; every leaf against its row, every row against the
/// leaves; and each chain against what the second place knows.
void checkLedger(Database& database, const LibraryWitness& witness, LibraryVerification& found);

} // namespace gripscope
