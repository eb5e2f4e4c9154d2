// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/people/acting.h"

namespace gripscope::cli {

/// Who changes the library, or arms a gripper. Once people are in it, that needs the consent of one who may,
/// a supervisor mostly (see mayDo()): the name is taken from the environment (GRIPSCOPE_PERSON), the PIN or
/// password is asked for on the terminal.
[[nodiscard]] Expected<Acting> authorization(Library& library, const QString& operatorName,
                                             Permission permission);
/// The same for a file that need not be there yet.
[[nodiscard]] Expected<Acting> authorization(const QString& libraryFile, const QString& operatorName,
                                             Permission permission);

} // namespace gripscope::cli
