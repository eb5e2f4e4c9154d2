// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QString>

namespace gripscope {

/// What is to be thought of an estimate, in a few words: "recommended", "agrees", "m −42 %, b +97 %", "did
/// not converge"... Others than the recommended one are measured against that.
[[nodiscard]] QString estimateVerdict(const Identification& identification, const Estimate& estimate);

/// Names of estimators for people: "output error", "ARX(2,1,1)".
[[nodiscard]] QString estimatorName(Estimator estimator);

/// A relative deviation with its sign: "+97 %", "−0.4 %", "+>999 %".
[[nodiscard]] QString deviationText(double share);

/// The name of a validity check for people.
[[nodiscard]] QString checkName(const QString& id);
/// The name of a step of the preparation for people.
[[nodiscard]] QString preparationName(const QString& id);

} // namespace gripscope
