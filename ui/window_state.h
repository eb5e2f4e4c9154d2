// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace gripscope {

class MainWindow;

/// Place and size of the window, its page, and how its pages are arranged (ui/page_state.h), as a document.
[[nodiscard]] QByteArray windowStateOf(const MainWindow& window);
/// Puts the window back; one that would lie beyond the screens of now comes onto one of them. What cannot be
/// read is as if it had never been kept.
void restoreWindowState(MainWindow& window, const QByteArray& state);

} // namespace gripscope
