// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

namespace gripscope {

/// Picks the part of a recording that is to be identified: where the device reports that the excitation is
/// moving (StatusMoving) the longest unbroken stretch of those samples, else the longest unbroken stretch of
/// all. `lostSamples` counts the samples missing inside the stretch asked for, `eligible` the samples it has.
struct WindowChoice {
    Window window;
    std::size_t eligible = 0;
    std::int64_t lostSamples = 0;
    std::size_t gaps = 0;
};
[[nodiscard]] WindowChoice chooseWindow(const Recording& recording);

/// The longest run of samples that all report the excitation moving, gaps or not, the first of equals;
/// without any such sample, everything.
[[nodiscard]] Window movingWindow(const Recording& recording);

} // namespace gripscope
