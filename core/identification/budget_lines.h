// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/effect_regression.h"
#include "core/identification/model_misfit.h"
#include "core/identification/uncertainty_budget.h"

#include <vector>

namespace gripscope {

/// The single lines of an uncertainty budget before they are added up; see uncertaintyBudget(), and
/// noise_lines.h for those of the noise. Effects that are not there give no line. `p` is what the line is
/// about, in the channels' units.

/// A line whose covariance in (ln m, ln b, ln k) is `relative`.
[[nodiscard]] BudgetLine lineOf(const QString& id, const QString& words, EvaluationType type,
                                const Eigen::Vector3d& p, const Eigen::Matrix3d& relative);

/// Lag and frame compliance.
[[nodiscard]] std::vector<BudgetLine> effectLines(const Eigen::Vector3d& p, const LinearizedRecord& record,
                                                  const MeasuringChain& chain);
/// The other hold of HoldEvidence, and a force that is smooth between its samples. `others`: the covariance
/// that all other lines add up to.
[[nodiscard]] std::vector<BudgetLine> holdLines(const Eigen::Vector3d& p,
                                                const std::optional<HoldAmbiguity>& hold, double coverage,
                                                const ModelMisfit& misfit, const Eigen::Matrix3d& others);
[[nodiscard]] std::vector<BudgetLine> calibrationLines(const Eigen::Vector3d& p, const MeasuringChain& chain);
[[nodiscard]] std::vector<BudgetLine> baselineLines(const GripperBaseline& baseline);
[[nodiscard]] std::vector<BudgetLine> discrepancyLines(const Eigen::Vector3d& p,
                                                       const std::optional<ModelDiscrepancy>& discrepancy,
                                                       const ModelMisfit& misfit);

} // namespace gripscope
