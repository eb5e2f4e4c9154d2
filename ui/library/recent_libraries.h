// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope {

class Settings;

/// Files of libraries, the newest first; of those that were opened last.
[[nodiscard]] QStringList recentLibraries(const Settings& settings);
void noteLibrary(Settings& settings, const QString& file);

} // namespace gripscope
