// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// Of the hidapi that runs.
[[nodiscard]] QString hidapiVersion();

} // namespace gripscope
