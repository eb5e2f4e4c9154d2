// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

class Database;
struct LibraryVerification;

/// The ledgers of libraries that were merged into this one: each chain by itself, each row as its station had
/// it, and that none ends before it did when it was merged.
void checkMerged(Database& database, LibraryVerification& found);

} // namespace gripscope
