// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/validation.h"

#include <QJsonObject>

namespace gripscope {

/// {"on": "second_window|other_recording", "file": ..|null, "as_expected": true|false|null, "message": ..,
/// "estimator": .., "parameters": {"m": .., ..},
///  "estimated_on": {"first": .., "samples": ..}, "validated_on": {..},
///  "fit": {"simulation_percent": .., "prediction_percent": .., "expected_percent": ..},
///  "residuals": {"whiteness_p": .., "input_independence_p": ..},
///  "misfit": {"p": .., "root_f": .., "change": {"m": .., "b": .., "k": ..}, "change_errors": {..}},
///  "nuisance": {"x0": .., "v0": .., "offset": ..}}; shares, not percent, in `change`.
[[nodiscard]] QJsonObject toJson(const Validation& validation);

} // namespace gripscope
