// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database_copy.h"
#include "core/library/tables/library_contents.h"
#include "core/library/verification/library_verification.h"

namespace gripscope {

struct LibraryBackup {
    LibraryContents contents;
    LibraryVerification verified; ///< of the copy, by what the second place knows of the library
};

/// A copy of the library as it stands now, also while programs write into it, verified once it is written.
/// The copy is kept also where something in it differs: that does so in the library, too. FileUnwritable:
/// there is a file of this name already. Usage: the library is on a server, and what copies it there. At 1
/// the progress is done with copying and verifies.
[[nodiscard]] Expected<LibraryBackup> backUpLibrary(const QString& library, const QString& copy,
                                                    const CopyProgress& progress);

/// What is in a library with the newest schema, as it stands.
[[nodiscard]] Expected<LibraryContents> contentsOfLibrary(const QString& file);

/// "library-2026-11-24.gripscope": what to call a copy.
[[nodiscard]] QString backupName(const QString& library, const QDate& today);

} // namespace gripscope
