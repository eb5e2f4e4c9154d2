// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"

#include <memory>

namespace gripscope::cli {

/// The path itself, if there is a file; else StorageOpen with the advice to enrol types.
[[nodiscard]] Expected<QString> existingLibraryFile(const QString& file);

/// Opens a library that is there; StorageOpen for one that is not.
[[nodiscard]] Expected<std::unique_ptr<Library>> openExistingLibrary(const QString& file);

} // namespace gripscope::cli
