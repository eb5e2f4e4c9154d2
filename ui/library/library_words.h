// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/backup/library_restore.h"

#include <QCoreApplication>

namespace gripscope {

/// What a library holds, and what a restore means for it, in words.
class LibraryWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::LibraryWords)
public:
    [[nodiscard]] static QString contents(const LibraryContents& contents);
    [[nodiscard]] static QString newest(const LibraryContents& contents);
    /// What the backup is to the library, and what would be lost.
    [[nodiscard]] static QString consequence(const RestorePlan& plan);
};

} // namespace gripscope
