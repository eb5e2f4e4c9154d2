// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/recognition/types/quantity_space.h"

#include <optional>

namespace gripscope {

/// The values of one quantity, both above zero.
struct QuantityRange {
    double lowest = 0, highest = 0;
    friend bool operator==(const QuantityRange&, const QuantityRange&) = default;
};

/// The background of every verdict, early or not: what a gripper may meet. Strangers are spread evenly in
/// the logarithms of the quantities over it. In the models' units; in SI, if nothing else is said, what parts
/// of a gram to ten kilograms have, four decades each of m, b and k; of the others what can be told at all.
struct InstrumentRange {
    MassDampingStiffness lowest{1e-3, 1e-1, 1e2};
    MassDampingStiffness highest{1e1, 1e3, 1e6};
    QuantityRange relaxingShare{1e-3, 1e1};  ///< k1/k
    QuantityRange relaxationTime{1e-4, 1e2}; ///< tau, in seconds
    QuantityRange friction{1e-3, 1e2};       ///< Fc
    [[nodiscard]] QuantityRange of(TypeQuantity quantity) const;
    /// (ln of the ratio) of each quantity of the space, multiplied; nothing unless 0 < lowest < highest, all
    /// finite, or for a space of none.
    [[nodiscard]] std::optional<double> logVolume(const QuantitySpace& space = {}) const;
    friend bool operator==(const InstrumentRange&, const InstrumentRange&) = default;
};

} // namespace gripscope
