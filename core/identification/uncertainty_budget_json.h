// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/derived_quantities.h"
#include "core/identification/model_comparison.h"
#include "core/identification/uncertainty_budget.h"

#include <QJsonArray>
#include <QJsonObject>

namespace gripscope {

// Numbers in the channels' units with full precision; what does not exist is null.

/// {"coverage", "message", "parameters": {m, b, k}, "covariance", "standard_uncertainties",
///  "degrees_of_freedom", "coverage_factors", "intervals": {"m": {"lower", "upper", "logarithmic",
///  "only_upper_bound"}, ..}, "lines": [{"id", "message", "type": "A|B", "standard_uncertainties",
///  "covariance", "degrees_of_freedom", "share"}]}. Degrees of freedom null: as good as infinite.
[[nodiscard]] QJsonObject toJson(const UncertaintyBudget& budget);

/// {"natural_frequency": {"name", "unit", "value", "standard_uncertainty", "lower", "upper",
///  "degrees_of_freedom", "message"}, ..}
[[nodiscard]] QJsonObject toJson(const std::vector<DerivedQuantity>& quantities);

/// {"criterion": "BIC", "decisive", "message", "models": [{"id", "message", "parameters": {m, b, k},
///  "unknowns", "noise_order", "log_likelihood", "criterion", "delta", "weight", "change_in_standard_errors",
///  "delay_s"}]}, best first.
[[nodiscard]] QJsonObject toJson(const ModelComparison& comparison);

} // namespace gripscope
