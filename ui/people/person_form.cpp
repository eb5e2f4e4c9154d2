// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/person_form.h"

#include "ui/people/secret_field.h"
#include "ui/widgets/controls.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

namespace gripscope {

PersonForm* PersonForm::forNew(bool first, QWidget* parent)
{
    auto* form = new PersonForm(
        first ? tr("Add the first supervisor") : tr("Add a person"),
        first
            ? tr("From now on roles are in force in this library: changing rates, limits, types, "
                 "calibrations, "
                 "settings and people needs a supervisor. This cannot be taken back, and nobody can read or "
                 "reset a lost PIN or password but another supervisor: add a second one soon.")
            : tr("Operators squeeze, inspect and enroll. Supervisors also change rates, limits, types, "
                 "calibrations, settings and people."),
        tr("Add"), parent);
    form->m_name = new QLineEdit(form);
    form->m_name->setObjectName("nameField");
    form->m_name->setMaxLength(60);
    form->addField(tr("Name, as it is to stand in the audit trail"), form->m_name);
    form->m_role = new QComboBox(form);
    form->m_role->setObjectName("roleField");
    for (const Role role : {Role::Operator, Role::Supervisor})
        if (!first || role == Role::Supervisor)
            form->m_role->addItem(inWords(role), static_cast<int>(role));
    form->addField(tr("Role"), form->m_role);
    form->addSecrets();
    form->m_name->setFocus();
    return form;
}

PersonForm* PersonForm::forSecret(const Person& person, QWidget* parent)
{
    auto* form = new PersonForm(
        tr("New PIN or password"),
        tr("For %1. The old one no longer counts, and a wait after wrong tries ends.").arg(person.name),
        tr("Change"), parent);
    form->addSecrets();
    form->m_secret->setFocus();
    return form;
}

PersonForm::PersonForm(const QString& title, const QString& words, const QString& verb, QWidget* parent)
    : QDialog(parent), m_fields(new QVBoxLayout), m_state(makeLabel({}, "error", this)),
      m_accept(makeButton(verb, {}, "primary", this))
{
    setObjectName("personForm");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(title);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 8);
    column->addWidget(makeLabel(title, "heading", this));
    QLabel* text = makeLabel(words, "", this);
    text->setWordWrap(true);
    column->addWidget(text);
    column->addSpacing(8);
    m_fields->setSpacing(4);
    column->addLayout(m_fields);
    m_state->setObjectName("personState");
    m_state->setWordWrap(true);
    m_state->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(m_state, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setAutoDefault(false);
    m_accept->setObjectName("personAccept");
    m_accept->setDefault(true);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(m_accept);
    column->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, &PersonForm::check);
}

void PersonForm::addField(const QString& label, QWidget* field)
{
    field->setAccessibleName(label);
    if (m_fields->count() > 0)
        m_fields->addSpacing(8);
    m_fields->addWidget(makeLabel(label, "caption", this));
    m_fields->addWidget(field);
}

void PersonForm::addSecrets()
{
    const QString what = tr("PIN of %1 digits or more, or password of %2 characters or more")
                             .arg(Secret::leastDigits)
                             .arg(Secret::leastCharacters);
    m_secret = makeSecretField(what, this);
    m_secret->setObjectName("secretField");
    addField(what, m_secret);
    m_accept->setEnabled(false);
    connect(m_secret, &QLineEdit::textChanged, this,
            [this](const QString& text) { m_accept->setEnabled(!text.isEmpty()); });
    m_again = makeSecretField(tr("The same again"), this);
    m_again->setObjectName("againField");
    addField(tr("The same again"), m_again);
    resize(480, layout()->totalHeightForWidth(480));
}

QString PersonForm::name() const
{
    return m_name ? m_name->text().simplified() : QString();
}

Role PersonForm::role() const
{
    return m_role ? static_cast<Role>(m_role->currentData().toInt()) : Role::Operator;
}

Secret PersonForm::takeSecret()
{
    m_again->clear();
    return gripscope::takeSecret(*m_secret);
}

void PersonForm::check()
{
    if (m_name && name().isEmpty())
        return showProblem(tr("The person needs a name."));
    if (m_secret->text() != m_again->text()) {
        m_again->clear();
        return showProblem(tr("The two are not the same. Type the second one again."));
    }
    m_state->clear();
    emit asked(); // what takes the secret leaves the field empty, and the button with it
}

void PersonForm::showProblem(const QString& problem)
{
    m_state->setText(problem);
    (m_name && name().isEmpty() ? m_name : m_secret->text().isEmpty() ? m_secret : m_again)->setFocus();
}

} // namespace gripscope
