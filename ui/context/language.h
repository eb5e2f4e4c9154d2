// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// Puts the words and numbers of the screen into a language ("en", "de") from here on; what is on the screen
/// already stays as it is. Files and the command line keep English words and decimal points. False where the
/// language is not known.
bool applyLanguage(const QString& code);
/// The one in force.
[[nodiscard]] QString currentLanguage();

} // namespace gripscope
