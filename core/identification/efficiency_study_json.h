// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/efficiency_study.h"

#include <QJsonObject>

namespace gripscope {

/// The document of `gripscope-cli study efficiency --json`. Numbers without runs behind them are null.
[[nodiscard]] QJsonObject toJson(const EfficiencyStudy& study, const EfficiencyOptions& options);

} // namespace gripscope
