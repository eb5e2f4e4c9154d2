// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/measuring_chain_record.h"

#include <optional>
#include <span>

namespace gripscope {

/// What a gripper is characterised by: each is measured by itself and corrects every later squeeze.
enum class GripperTrait {
    Baseline,   ///< m, b, k of the empty gripper
    Friction,   ///< of its drive
    ForceNoise, ///< of its force at rest
    Frame,      ///< how far frame and fingers give way
    Lag,        ///< of the position behind the force
};

/// Somebody measured it.
[[nodiscard]] bool isKnown(GripperTrait trait, const NewMeasuringChain& chain);

/// The measurement by which the trait has the value that is in force: the oldest of the newest ones that have
/// it. `newestFirst`: of one gripper. Nothing where the trait is not known.
[[nodiscard]] std::optional<MeasuringChainRecord>
measurementOf(GripperTrait trait, std::span<const MeasuringChainRecord> newestFirst);

} // namespace gripscope
