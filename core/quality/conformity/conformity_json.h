// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/conformity/conformity.h"

#include <QJsonObject>

namespace gripscope {

/// {"decision":"does_not_conform", "rule":"iso14253", "risk":null, "si_factor":.., "quantities":{"k":{
///  "decision":.., "value":.., "standard_uncertainty":.., "lower":.., "upper":.., "guard":.., "risk":..}}},
///  in
/// the units of the limits; null: none.
[[nodiscard]] QJsonObject conformityJson(const Conformity& conformity);
/// Nothing for what conformityJson() does not make.
[[nodiscard]] std::optional<Conformity> conformityFromJson(const QJsonObject& document);

} // namespace gripscope
