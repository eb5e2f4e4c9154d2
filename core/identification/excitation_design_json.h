// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/excitation_design.h"

#include <QJsonObject>

namespace gripscope {

/// The document of `gripscope-cli design --json`; the force of the best candidate alone, in full.
[[nodiscard]] QJsonObject toJson(const ExcitationDesign& design, const DesignOptions& options);

} // namespace gripscope
