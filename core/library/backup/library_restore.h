// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database_copy.h"
#include "core/library/tables/library_contents.h"
#include "core/people/acting.h"

#include <optional>

namespace gripscope {

/// What a backup is to the library whose place it is to take.
enum class Kinship {
    Same,    ///< nothing was stored since
    Earlier, ///< all that is in the backup is in the library
    Apart,   ///< both have something that the other has not
    Other    ///< another library
};

/// A verified copy of a backup, of this program's schema, beside the library.
struct RestorePlan {
    QString library, backup;
    QString staged; ///< the copy
    LibraryContents holds;
    std::optional<LibraryContents> present; ///< of the library; nothing where it cannot be read
    Kinship kinship = Kinship::Other;
};

/// Copies the backup beside the library and verifies it there as `library verify` does; the library is only
/// looked at. StorageCorrupt: something in the backup is not as it was written, and what. StorageNewer: a
/// newer program wrote the library. StorageOpen, StorageFailed: it cannot be looked at now, and may be whole.
/// Usage: it is the library itself; or the library is on a server, and what puts it back there. Whoever does
/// not go on removes the copy by discard().
[[nodiscard]] Expected<RestorePlan> prepareRestore(const QString& library, const QString& backup,
                                                   const CopyProgress& progress);
void discard(const RestorePlan& plan);

/// Puts the copy in the library's place, and keeps the library beside it under the name that is returned:
/// nothing is lost. No program has the library open. Both audit trails tell of it, with the reason; so does
/// each later verification. What the second place knows follows (library_witness.h).
///
/// Killed at any moment, the library is there, or Library::open() finishes what was begun. Usage: no reason,
/// or not permitted (Permission::RestoreLibrary, by the people of the library; a library that cannot be read
/// has none). After a failure the library is as it was, and the plan is used up.
[[nodiscard]] Expected<QString> restoreLibrary(const RestorePlan& plan, const Acting& acting,
                                               const QString& reason);

} // namespace gripscope
