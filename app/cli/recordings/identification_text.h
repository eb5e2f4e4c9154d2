// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QString>

namespace gripscope::cli {

/// An identification for a person to read: values with their standard errors and units, which fit is which,
/// and what an ARX fit does not say.
[[nodiscard]] QString identificationText(const Identification& identification, const Recording& recording,
                                         const QString& file);

} // namespace gripscope::cli
