// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"
#include "ui/people/sign_in.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace gripscope {

class PersonForm;

/// Who is in the library, and what they may; people are added, given another role or a new PIN or password,
/// and deactivated, never deleted.
class PeopleDialog : public QDialog {
    Q_OBJECT
public:
    explicit PeopleDialog(Workbench& workbench, QWidget* parent = nullptr);

private:
    using Change = std::function<Expected<void>(Library&)>;
    QPushButton* addAction(QVBoxLayout* column, const QString& text, const char* name,
                           void (PeopleDialog::*action)());
    void showPeople();
    void refresh();
    [[nodiscard]] const Person* selected() const;
    /// On the library's thread, with a supervisor's consent where that is needed; closes `form` when it is
    /// done.
    void change(Change work, PersonForm* form = nullptr);
    void add();
    void changeRole();
    void changeSecret();
    void changeActive();

    Workbench* m_workbench;
    std::vector<Person> m_shown;
    QTableWidget* m_table;
    QLabel *m_intro, *m_state;
    QPushButton *m_add, *m_role, *m_secret, *m_active;
};

} // namespace gripscope
