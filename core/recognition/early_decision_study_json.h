// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/early_decision_study.h"

#include <QJsonObject>

namespace gripscope {

/// The document of `gripscope-cli study early --json`.
[[nodiscard]] QJsonObject toJson(const std::vector<EarlyDecisionStudy>& rows,
                                 const EarlyDecisionStudyOptions& options);

} // namespace gripscope
