// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/bias/linearity_study.h"
#include "core/quality/bias/type_one_study.h"

#include <QJsonObject>

namespace gripscope {

/// As `gripscope-cli study type1` and `study linearity` print them; intervals are [lower, upper], and what
/// does not exist is null.
[[nodiscard]] QJsonObject toJson(const TypeOneStudy& study);
[[nodiscard]] QJsonObject toJson(const LinearityStudy& study);

} // namespace gripscope
