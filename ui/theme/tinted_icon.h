// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

#include <optional>

namespace gripscope {

/// A monochrome SVG of the breeze icons as a stencil for one colour, drawn anew at the size asked for.
/// Without a colour it takes the theme's text colour at the moment it is painted, so it follows a change of
/// theme by itself. Empty when there is no such icon.
[[nodiscard]] QIcon tintedIcon(const QString& name, std::optional<QColor> color);

} // namespace gripscope
