// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// What takes the place of a library lies under this name in the moment between: whole, verified, agreed to.
[[nodiscard]] QString nextInPlace(const QString& library);

/// Where the library is gone and the next one waits, a restore was killed between: it takes its place. What
/// lies beside it of the library that is gone is kept under another name. True when there is a library of
/// this name then.
bool finishSwap(const QString& library);

} // namespace gripscope
