// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/people_dialog.h"

#include "core/store/people_register.h"
#include "ui/people/authorize.h"
#include "ui/people/person_form.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/date_text.h"
#include "ui/widgets/row_list.h"
#include "ui/workbench.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPointer>
#include <QTableWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QTableWidget* makePeopleTable(const QStringList& headers, QWidget* parent)
{
    auto* table = new QTableWidget(0, static_cast<int>(headers.size()), parent);
    table->setObjectName("peopleTable");
    table->setHorizontalHeaderLabels(headers);
    setUpRowList(table, 40);
    table->setWordWrap(true); // a long name has the room for two lines
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    return table;
}

} // namespace

PeopleDialog::PeopleDialog(Workbench& workbench, QWidget* parent)
    : QDialog(parent), m_workbench(&workbench), m_intro(makeLabel({}, "", this)),
      m_state(makeLabel({}, "error", this))
{
    setObjectName("peopleDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("People"));
    m_intro->setWordWrap(true);
    m_state->setObjectName("peopleState");
    m_state->setWordWrap(true);
    m_table = makePeopleTable({tr("Name"), tr("Role"), tr("State"), tr("Since")}, this);
    m_table->setAccessibleName(tr("People"));
    auto* actions = new QVBoxLayout;
    actions->setSpacing(8);
    m_add = addAction(actions, tr("Add…"), "addPersonButton", &PeopleDialog::add);
    m_role = addAction(actions, tr("Make supervisor"), "roleButton", &PeopleDialog::changeRole);
    m_secret = addAction(actions, tr("New PIN…"), "secretButton", &PeopleDialog::changeSecret);
    m_secret->setToolTip(tr("New PIN or password"));
    m_active = addAction(actions, tr("Deactivate"), "activeButton", &PeopleDialog::changeActive);
    actions->addStretch(1);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(m_table, 1);
    row->addLayout(actions);
    QPushButton* close = makeButton(tr("Close"), {}, "primary", this);
    close->setAutoDefault(false);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_state, 1);
    foot->addWidget(close);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 12);
    column->addWidget(m_intro);
    column->addLayout(row, 1);
    column->addLayout(foot);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &PeopleDialog::refresh);
    connect(&workbench.signIn(), &SignIn::changed, this, &PeopleDialog::showPeople);
    resize(720, 440);
    showPeople();
    workbench.signIn().reload();
}

QPushButton* PeopleDialog::addAction(QVBoxLayout* column, const QString& text, const char* name,
                                     void (PeopleDialog::*action)())
{
    QPushButton* button = makeButton(text, {}, "", this);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    button->setMinimumWidth(160);
    connect(button, &QPushButton::clicked, this, action);
    column->addWidget(button);
    return button;
}

void PeopleDialog::showPeople()
{
    const QString before = selected() ? selected()->id : QString();
    m_shown = m_workbench->signIn().people();
    m_intro->setText(
        m_shown.empty()
            ? tr("Nobody is in this library yet, so everything is allowed to everybody, and the "
                 "operator's name is what somebody typed. Add the first person, who must be a "
                 "supervisor, and roles are in force from then on.")
            : tr("Roles are in force. Who leaves is deactivated, not deleted: what they did stays "
                 "in the audit trail."));
    m_table->setRowCount(static_cast<int>(m_shown.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const Person& person = m_shown[static_cast<std::size_t>(row)];
        const QStringList texts = {person.name, inWords(person.role),
                                   person.active ? tr("active") : tr("deactivated"), dateText(person.since)};
        for (int column = 0; column < texts.size(); ++column)
            m_table->setItem(row, column, new QTableWidgetItem(texts[column]));
        if (person.id == before)
            m_table->selectRow(row);
    }
    refresh();
}

void PeopleDialog::refresh()
{
    const Person* person = selected();
    m_role->setEnabled(person && person->active);
    m_secret->setEnabled(person && person->active);
    m_active->setEnabled(person);
    m_role->setText(person && person->role == Role::Supervisor ? tr("Make operator") : tr("Make supervisor"));
    m_active->setText(person && !person->active ? tr("Reactivate") : tr("Deactivate"));
}

const Person* PeopleDialog::selected() const
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    const auto row = rows.isEmpty() ? m_shown.size() : static_cast<std::size_t>(rows.first().row());
    return row < m_shown.size() ? &m_shown[row] : nullptr;
}

void PeopleDialog::change(Change work, PersonForm* form)
{
    const QPointer<PersonForm> open(form);
    m_workbench->ask<void>(this, std::move(work), [this, open](const Expected<void>& done) {
        const QString problem = done ? QString() : done.error().describe();
        m_state->setText(open ? QString() : problem);
        if (open && !done)
            return open->showProblem(problem);
        if (open)
            open->accept();
        m_workbench->signIn().reload();
    });
}

void PeopleDialog::add()
{
    auto* form = PersonForm::forNew(!m_workbench->signIn().inForce(), this);
    connect(form, &PersonForm::asked, this, [this, form] {
        const auto secret = std::make_shared<Secret>(form->takeSecret());
        authorize(*m_workbench, form, Permission::ManagePeople, [this, form, secret] {
            change(
                [name = form->name(), role = form->role(), secret](Library& library) {
                    return library.people().add(name, role, *secret).map([](const Person&) {});
                },
                form);
        });
    });
    form->open();
}

void PeopleDialog::changeRole()
{
    const Person person = *selected();
    const Role role = person.role == Role::Supervisor ? Role::Operator : Role::Supervisor;
    authorize(*m_workbench, this, Permission::ManagePeople, [this, id = person.id, role] {
        change([id, role](Library& library) { return library.people().setRole(id, role); });
    });
}

void PeopleDialog::changeSecret()
{
    const Person person = *selected();
    auto* form = PersonForm::forSecret(person, this);
    connect(form, &PersonForm::asked, this, [this, form, id = person.id] {
        const auto secret = std::make_shared<Secret>(form->takeSecret());
        const auto replace = [this, form, id, secret] {
            change([id, secret](Library& library) { return library.people().setSecret(id, *secret); }, form);
        };
        const std::optional<Authority>& self = m_workbench->signIn().current();
        if (self && self->personId() == id) // one's own
            replace();
        else
            authorize(*m_workbench, form, Permission::ManagePeople, replace);
    });
    form->open();
}

void PeopleDialog::changeActive()
{
    const Person person = *selected();
    authorize(*m_workbench, this, Permission::ManagePeople, [this, id = person.id, active = !person.active] {
        change([id, active](Library& library) { return library.people().setActive(id, active); });
    });
}

} // namespace gripscope
