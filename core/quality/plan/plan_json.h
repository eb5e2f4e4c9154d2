// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/plan/study_plan.h"

#include <QJsonObject>

namespace gripscope {

/// A plan as it is stored: the design with its seed, and every row, so that it reads the same should another
/// version draw another order.
[[nodiscard]] QJsonObject planJson(const StudyPlan& plan);
/// BadInput for what planJson() does not make.
[[nodiscard]] Expected<StudyPlan> planFromJson(const QJsonObject& json);

} // namespace gripscope
