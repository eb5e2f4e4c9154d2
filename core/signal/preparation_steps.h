// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/preparation.h"
#include "core/signal/sample_clock.h"

#include <optional>
#include <vector>

namespace gripscope {

// What prepare() did and noticed, in numbers and words.

[[nodiscard]] PreparationStep unusableStep();
[[nodiscard]] PreparationStep contactStep(const ContactPhases& phases, Window asked);
[[nodiscard]] PreparationStep forceNoiseStep(std::size_t samples, double deviation);
[[nodiscard]] PreparationStep driftStep(const SampleClock& clock, double nominal_s);
[[nodiscard]] PreparationStep breakStep(const SampleClock& clock);
[[nodiscard]] PreparationStep jitterStep(const SampleClock& clock, bool moved);
[[nodiscard]] PreparationStep lostStep(const WindowChoice& choice);
[[nodiscard]] PreparationStep cutStep(Window used, Window squeeze);
[[nodiscard]] PreparationStep contactLossStep(const std::vector<std::size_t>& away, std::size_t samples);
[[nodiscard]] PreparationStep frameStep(double compliance);

/// Samples at a sensor's end by the device's word (status bits) or by their look (clippedSamples()).
[[nodiscard]] std::optional<PreparationStep> saturationStep(const Recording& recording, Window used);
/// A position that comes in steps larger than its noise and than a ten-thousandth of its range: its errors
/// are then neither white nor independent of the motion.
[[nodiscard]] std::optional<PreparationStep> quantizationStep(const Recording& recording, Window used);

} // namespace gripscope
