// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/result/identification_result.h"

#include <array>
#include <span>

namespace gripscope {

/// Hold, lag and its uncertainty as identify() takes them to be declared: evidence that says nothing yet.
[[nodiscard]] HoldEvidence holdDeclaration(const Recording& recording, const IdentificationOptions& options);

/// Prepares the record (preparation.h), runs every estimator asked for, and judges the measurement. Where the
/// position is held, `static` is run and recommended whatever was asked for: no other applies. Pure; never
/// throws for data.
[[nodiscard]] Identification identify(const Recording& recording, const IdentificationOptions& options = {});

/// m, b, k of one object from several squeezes, in the channels' units, without the empty gripper's where
/// that is known.
struct RepeatedMeasurement {
    MassDampingStiffness parameters;
    std::array<double, 3> ownErrors{};    ///< standard, of the mean: the squeezes' noise and their scatter
    std::array<double, 3> sharedErrors{}; ///< standard: what all squeezes of the gripper have in common
    [[nodiscard]] double standardUncertainty(std::size_t parameter) const;
};

/// The pooled means of the squeezes (pooledMean()), each with the type A lines of its budget as its own
/// error; shared are the type B lines (calibration, lag, frame, baseline), the largest of the squeezes, since
/// repeating does not average them out (JCGM 100, 5.2). Nothing without squeezes, or when one has no m, b, k
/// above zero with a budget.
[[nodiscard]] std::optional<RepeatedMeasurement>
repeatedMeasurement(std::span<const Identification> squeezes);

} // namespace gripscope
