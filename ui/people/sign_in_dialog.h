// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/acting.h"
#include "ui/windows/dialog.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gripscope {

class Workbench;

/// Asks who it is and for the PIN or password: to sign in, or, with a permission, for a supervisor's consent
/// to one action. Closes when it was right.
class SignInDialog : public Dialog {
    Q_OBJECT
public:
    SignInDialog(Workbench& workbench, std::optional<Permission> permission, QWidget* parent = nullptr);

signals:
    void authorised(const Grant& grant); ///< only with a permission

private:
    void fill();
    void refresh();
    void check();
    void finish(const std::optional<QString>& problem);
    Workbench* m_workbench;
    std::optional<Permission> m_permission;
    QComboBox* m_person;
    QLineEdit* m_secret;
    QLabel* m_state;
    QPushButton* m_accept;
    bool m_checking = false;
};

} // namespace gripscope
