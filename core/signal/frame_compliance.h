// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

#include <vector>

namespace gripscope {

/// The position of the object itself when frame and fingers yield in series with it:
///     x[n] = position[n] - compliance F(t_n + lag),
/// F(t_n + lag) read from the sampled force as it is held (the force's last value beyond its ends). Assumes
/// that frame and fingers yield at once: their own natural frequency is far above the object's. `compliance`
/// is measured on a rigid block, in position units per force unit (science: left out, k comes out too small
/// by compliance times k). `lag` is in samples. The vectors are equally long; numbers that do not give a
/// finite result leave the position as it is.
[[nodiscard]] std::vector<double> withoutFrame(const std::vector<double>& position,
                                               const std::vector<double>& force, double compliance,
                                               double lag = 0, ForceHold hold = ForceHold::First);

} // namespace gripscope
