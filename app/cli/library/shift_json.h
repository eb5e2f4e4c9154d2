// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_shift.h"

#include <QJsonObject>

namespace gripscope::cli {

/// {"m": .., "b": .., "k": ..}
[[nodiscard]] QJsonObject vectorJson(const Eigen::Vector3d& values);
/// {"type", "squeezes", "log", "standard_errors", "t_squared", "p"}: the logs of m, b and k.
[[nodiscard]] QJsonObject shiftJson(const TypeShift& shift);
/// {"value", "standard_errors", "covariance", "p", "agreement_p"}
[[nodiscard]] QJsonObject commonShiftJson(const CommonShift& shift);

} // namespace gripscope::cli
