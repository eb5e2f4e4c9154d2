// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/inspection/self_test.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace gripscope {

class Workbench;

/// Tests the gripper without moving it; a line for each question with its figure, limit, tick or cross, and
/// what to do.
class SelfTestTab : public QWidget {
    Q_OBJECT
public:
    explicit SelfTestTab(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] const SelfTest& test() const { return m_test; }
    void start();

private:
    void follow();
    void showLines();
    Workbench* m_workbench;
    SelfTest m_test;
    QPushButton* m_start;
    QProgressBar* m_progress;
    QLabel* m_verdict;
    QTableWidget* m_table;
};

} // namespace gripscope
