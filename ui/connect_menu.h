// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/gripper_factory.h"

#include <QMenu>

namespace gripscope {

class Workbench;

/// Which gripper to connect to: the virtual one with any of its cans, those found on USB (looked for off the
/// screen's thread each time the menu opens), an address typed in, or none.
class ConnectMenu : public QMenu {
    Q_OBJECT
public:
    explicit ConnectMenu(Workbench& workbench, QWidget* parent = nullptr);

private:
    void rebuild();
    void look();
    void showFound(const std::vector<FoundDevice>& devices);
    void askForAddress();
    QAction* addAddress(const QString& text, const QString& address);

    Workbench* m_workbench;
    QAction* m_looking = nullptr;
    QAction* m_afterFound = nullptr;
};

} // namespace gripscope
