// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace gripscope {

/// A colour for a number between 0 (dark blue) and 1 (yellow): lightness rises evenly, and it reads the same
/// to people with any kind of colour blindness. Numbers outside are taken for the nearer end.
/// Source: Nunez, Anderton and Renslow, Optimizing colormaps with consideration for color vision deficiency
/// (cividis, 2018), ten of its colours with straight lines between them.
[[nodiscard]] QColor scaleColor(double share);

} // namespace gripscope
