// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/window_in_front.h"

#include <QApplication>
#include <QWidget>

#include <algorithm>

namespace gripscope {

QWidget* windowInFront()
{
    if (QWidget* active = QApplication::activeWindow())
        return active;
    const QWidgetList windows = QApplication::topLevelWidgets();
    const auto shown = std::find_if(windows.begin(), windows.end(), [](const QWidget* one) {
        return one->isVisible() && one->windowType() == Qt::Window;
    });
    return shown == windows.end() ? nullptr : *shown;
}

} // namespace gripscope
