// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <optional>

namespace gripscope {

/// Of a library on a server: by which command of its own it is copied, and put back; nothing for a file.
[[nodiscard]] std::optional<Error> copiedByServer(const QString& library, const QString& copy);
[[nodiscard]] std::optional<Error> putBackByServer(const QString& library, const QString& backup);

} // namespace gripscope
