// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/person.h"
#include "core/people/secret.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace gripscope {

/// Asks for a new person, or for a new PIN or password of one who is there. Stays open with what was typed,
/// but for the secret, until told that it is done.
class PersonForm : public QDialog {
    Q_OBJECT
public:
    /// `first`: nobody is there yet, and this one will be a supervisor.
    static PersonForm* forNew(bool first, QWidget* parent);
    static PersonForm* forSecret(const Person& person, QWidget* parent);

    [[nodiscard]] QString name() const;
    [[nodiscard]] Role role() const;
    /// Once; the fields are empty then.
    [[nodiscard]] Secret takeSecret();
    void showProblem(const QString& problem);

signals:
    void asked(); ///< what was typed makes sense so far

private:
    PersonForm(const QString& title, const QString& words, const QString& verb, QWidget* parent);
    void addField(const QString& label, QWidget* field);
    void addSecrets();
    void check();
    QVBoxLayout* m_fields;
    QLineEdit* m_name = nullptr;
    QComboBox* m_role = nullptr;
    QLineEdit *m_secret = nullptr, *m_again = nullptr;
    QLabel* m_state;
    QPushButton* m_accept;
};

} // namespace gripscope
