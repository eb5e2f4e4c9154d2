// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <optional>

namespace gripscope {

/// The background of every verdict, early or not: what a gripper may meet. Strangers are spread evenly in
/// log m, log b and log k over it. In the models' units; in SI, if nothing else is said, what parts of a gram
/// to ten kilograms have, four decades each.
struct InstrumentRange {
    MassDampingStiffness lowest{1e-3, 1e-1, 1e2};
    MassDampingStiffness highest{1e1, 1e3, 1e6};
    /// (ln of the ratio) of m, b and k, multiplied; nothing unless 0 < lowest < highest, all finite.
    [[nodiscard]] std::optional<double> logVolume() const;
    friend bool operator==(const InstrumentRange&, const InstrumentRange&) = default;
};

} // namespace gripscope
