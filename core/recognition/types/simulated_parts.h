// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <QString>

#include <vector>

namespace gripscope {

/// A part that goes on yielding, made up: round numbers of the size that such parts have. Nobody measured it.
struct SimulatedPart {
    QString key;                                    ///< in addresses: "tomato"
    QString name;                                   ///< as a type: "Tomato (simulated)"
    MassDampingStiffness centre;                    ///< SI, k the relaxed one
    double relaxingShare = 0, relaxationTime_s = 0; ///< k1 / k, tau
};

/// Plastics, foams and fruit, two of each.
[[nodiscard]] const std::vector<SimulatedPart>& simulatedParts();
/// Nothing where no part has that key.
[[nodiscard]] const SimulatedPart* simulatedPart(const QString& key);

} // namespace gripscope
