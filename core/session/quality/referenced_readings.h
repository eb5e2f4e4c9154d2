// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/session/quality/kept_study.h"

namespace gripscope {

/// Readings of the quantity that a type-1 or linearity study is about, in the order in which they were made,
/// each beside what its part is; in the unit of the measurements.
struct ReferencedReadings {
    std::vector<double> references, values;
    QString unit;
    std::optional<MechanicalQuantity> quantity; ///< where that unit is SI
};
/// BadInput where a squeeze did not determine that quantity, a reference is no number, nothing counts, or the
/// readings are in several units.
[[nodiscard]] Expected<ReferencedReadings> referencedReadings(const KeptStudy& study);

} // namespace gripscope
