// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QDateTime>

namespace gripscope {

class Database;

/// How much is in a library, and how new it is.
struct LibraryContents {
    qint64 types = 0; ///< retired ones too
    qint64 squeezes = 0, inspections = 0, calibrations = 0;
    qint64 entries = 0; ///< of the audit trail
    qint64 version = 0; ///< of the types
    QDateTime newest;   ///< when something was stored last; invalid: never
    friend bool operator==(const LibraryContents&, const LibraryContents&) = default;
};

/// Of one with the newest schema. Reads whole tables: not for the screen's thread.
[[nodiscard]] Expected<LibraryContents> contentsOf(Database& database);

} // namespace gripscope
