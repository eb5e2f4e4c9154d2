// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/people/acting.h"

#include <vector>

namespace gripscope {

class Database;

/// Whether the one who works through this connection may do it now: everybody while no people are in the
/// library; else who is signed in or has consented, with the role that is stored for them at this moment.
/// Usage, worded, when not. Inside the transaction of what is to be done.
[[nodiscard]] Expected<void> requirePermission(Database& database, Permission permission);
/// By whom it may be done then: who consented and who is signed in, as far as either may. Empty also while no
/// people are in the library.
[[nodiscard]] Expected<std::vector<Authority>> whoMay(Database& database, Permission permission);

} // namespace gripscope
