// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// A file that was made or renamed keeps its name through a power cut from here on: what is in it is synced
/// with the file, its name with its folder. Some file systems do that by themselves, and where it cannot be
/// asked for nothing more can be done.
void syncNames(const QString& file);

} // namespace gripscope
