// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace gripscope {

/// A square button with a sign (or a letter) and its meaning as tool tip and accessible name.
[[nodiscard]] QToolButton* makeToolButton(const QString& text, const QString& icon, const QString& tip);

} // namespace gripscope
