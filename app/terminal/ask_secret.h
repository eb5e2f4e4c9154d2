// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/secret.h"

namespace gripscope {

/// Asks on the terminal itself, whatever standard input and output are, and shows nothing of what is typed.
/// Usage where there is no terminal: a secret on a command line or in a file is none.
[[nodiscard]] Expected<Secret> askSecret(const QString& prompt);

} // namespace gripscope
