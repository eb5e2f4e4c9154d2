// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace gripscope {

class ConnectMenu;
class DeviceChip;
class Workbench;

/// The row above every page: its title, the gripper, who works, armed or not, and Stop.
class HeaderBar : public QFrame {
    Q_OBJECT
public:
    explicit HeaderBar(Workbench& workbench, QWidget* parent = nullptr);
    void setTitle(const QString& title);

private:
    void refreshLink();
    void refreshArmed();
    Workbench* m_workbench;
    QLabel* m_title;
    DeviceChip* m_chip;
    ConnectMenu* m_menu;
    QPushButton* m_arm;
    QPushButton* m_stop;
};

} // namespace gripscope
