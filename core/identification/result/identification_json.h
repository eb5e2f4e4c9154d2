// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/comparison/model_comparison.h"
#include "core/identification/periodic/periodic.h"
#include "core/identification/result/identification_result.h"
#include "core/identification/uncertainty/derived_quantities.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "core/identification/validation/validation.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

namespace gripscope {

/// The document of `gripscope-cli identify --json`; its sentences are English.
[[nodiscard]] QJsonObject toJson(const Identification& identification, const Recording& recording,
                                 const QString& file);
/// The same as the library keeps it: with `finding` (Finding::toJson()) in each line of the budget, to be
/// worded in the language of whoever reads it later.
[[nodiscard]] QJsonObject documentToKeep(const Identification& identification, const Recording& recording,
                                         const QString& source);

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

/// {"on": "second_window|other_recording", "file": ..|null, "as_expected": true|false|null, "message": ..,
/// "estimator": .., "parameters": {"m": .., ..},
///  "estimated_on": {"first": .., "samples": ..}, "validated_on": {..},
///  "fit": {"simulation_percent": .., "prediction_percent": .., "expected_percent": ..},
///  "residuals": {"whiteness_p": .., "input_independence_p": ..},
///  "misfit": {"p": .., "root_f": .., "change": {"m": .., "b": .., "k": ..}, "change_errors": {..}},
///  "nuisance": {"x0": .., "v0": .., "offset": ..}}; shares, not percent, in `change`.
[[nodiscard]] QJsonObject toJson(const Validation& validation);

/// {"period_samples": .., "periods": .., "noise": {"force": .., "position": .., "correlation": ..},
///  "drift": {"force": .., "position": ..}, "cost": {"ratio": .., "p": ..}, "distortion": {"percent": ..,
///  "p": ..}, "lines": [{"frequency_hz": .., "real": .., "imaginary": .., "deviation": ..}]}, channel units.
///  `distortion`
/// is null where there are no empty harmonics; a number that is not finite is null.
[[nodiscard]] QJsonObject toJson(const PeriodicDiagnostics& diagnostics);

} // namespace gripscope
