// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// Of a connection as Qt knows it.
[[nodiscard]] QString uniqueConnectionName();

} // namespace gripscope
