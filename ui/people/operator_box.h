// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;

namespace gripscope {

class Workbench;

/// Who works here, in the header: a field for the name while nobody has to sign in, else who has signed in;
/// and the menu for signing in and out, people and the audit trail.
class OperatorBox : public QWidget {
    Q_OBJECT
public:
    explicit OperatorBox(Workbench& workbench, QWidget* parent = nullptr);

private:
    void makeField();
    void refresh();
    void fillMenu();
    Workbench* m_workbench;
    QLabel* m_caption;
    QLineEdit* m_name;
    QPushButton* m_chip;
    QMenu* m_menu;
};

} // namespace gripscope
