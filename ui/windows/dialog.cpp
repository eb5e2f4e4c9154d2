// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windows/dialog.h"

#include <QEvent>
#include <QLayout>

#include <algorithm>

namespace gripscope {

// Of the window, not of the page: what a style sheet says of what lies in a page is not said of it.
Dialog::Dialog(QWidget* parent, Conduct conduct)
    : QDialog(parent ? parent->window() : nullptr), m_conduct(conduct)
{
    setWindowModality(Qt::NonModal);
}

void Dialog::open()
{
    // QDialog's own would make the window modal.
    setResult(0);
    show();
    raise();
    activateWindow();
}

bool Dialog::event(QEvent* event)
{
    constexpr int leastScreen_px = 640;
    const bool handled = QDialog::event(event);
    if ((event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest) && layout() &&
        layout()->hasHeightForWidth()) {
        const int needed = std::min(layout()->totalMinimumHeightForWidth(width()), leastScreen_px);
        if (needed > height())
            resize(width(), needed);
    }
    return handled;
}

std::vector<DialogRow>& dialogTable()
{
    static std::vector<DialogRow> table;
    return table;
}

} // namespace gripscope
