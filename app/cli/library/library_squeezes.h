// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/recognition/types/type_model.h"

#include <memory>
#include <vector>

namespace gripscope::cli {

// What a library holds, all in the same units: SI where the channels' units are known.

/// The path itself, if there is a file; else StorageOpen with the advice to enrol types.
[[nodiscard]] Expected<QString> existingLibraryFile(const QString& file);

/// Opens a library that is there; StorageOpen for one that is not.
[[nodiscard]] Expected<std::unique_ptr<Library>> openExistingLibrary(const QString& file);

/// The approved types, and the squeezes they were enrolled with: what verdicts are made of.
[[nodiscard]] Expected<TypeModels> approvedModels(Library& library);

/// The inspected squeezes, oldest first, with the type they are of: the expected one where it was stated,
/// else the one that was named. `leftOut` counts those of neither and those without m, b and k.
struct InspectedSqueezes {
    std::vector<TypeSqueeze> squeezes;
    int leftOut = 0;
};
[[nodiscard]] Expected<InspectedSqueezes> inspectedSqueezes(Library& library);

} // namespace gripscope::cli
