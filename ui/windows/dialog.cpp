// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windows/dialog.h"

namespace gripscope {

Dialog::Dialog(QWidget* parent, Conduct conduct) : QDialog(parent), m_conduct(conduct)
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

std::vector<DialogRow>& dialogTable()
{
    static std::vector<DialogRow> table;
    return table;
}

} // namespace gripscope
