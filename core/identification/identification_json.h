// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QJsonObject>
#include <QString>

namespace gripscope {

/// The document of `gripscope-cli identify --json`; also what the library keeps of an identification.
[[nodiscard]] QJsonObject toJson(const Identification& identification, const Recording& recording,
                                 const QString& file);

} // namespace gripscope
