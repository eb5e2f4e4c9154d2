// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/periodic.h"

#include <QJsonObject>

namespace gripscope {

/// {"period_samples": .., "periods": .., "noise": {"force": .., "position": .., "correlation": ..},
///  "drift": {"force": .., "position": ..}, "cost": {"ratio": .., "p": ..}, "distortion": {"percent": ..,
///  "p": ..}, "lines": [{"frequency_hz": .., "real": .., "imaginary": .., "deviation": ..}]}, channel units.
///  `distortion`
/// is null where there are no empty harmonics; a number that is not finite is null.
[[nodiscard]] QJsonObject toJson(const PeriodicDiagnostics& diagnostics);

} // namespace gripscope
