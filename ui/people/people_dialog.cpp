// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/people/people_register.h"
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/people/authorize.h"
#include "ui/people/people_dialogs.h"
#include "ui/people/secret_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPointer>
#include <QTableWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
const RegisteredDialog<PersonForm> personFormRow("person", [](Workbench&, QWidget* over) {
    return PersonForm::forNew(true, over);
});
} // namespace

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
    : Dialog(parent), m_fields(new QVBoxLayout), m_state(makeLabel({}, "error", this)),
      m_accept(makeButton(verb, {}, "primary", this))
{
    setObjectName("personForm");
    setManualPage(u"people"_s);
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

const RegisteredDialog<PeopleDialog> peopleDialogRow("people", [](Workbench& bench, QWidget* over) {
    return new PeopleDialog(bench, over);
});
} // namespace

PeopleDialog::PeopleDialog(Workbench& workbench, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench), m_intro(makeLabel({}, "", this)),
      m_state(makeLabel({}, "error", this))
{
    setObjectName("peopleDialog");
    setManualPage(u"people"_s);
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
    column->addLayout(makeArmingRow());
    column->addLayout(makeApprovalRow());
    column->addLayout(foot);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &PeopleDialog::refresh);
    connect(&workbench.signIn(), &SignIn::changed, this, &PeopleDialog::showPeople);
    resize(720, 440);
    showPeople();
    workbench.signIn().reload();
}

QHBoxLayout* PeopleDialog::makeArmingRow()
{
    m_arming = new QComboBox(this);
    m_arming->setObjectName("armingPolicy");
    m_arming->addItem(tr("everybody who has signed in"), toString(ArmingPolicy::SignedIn));
    m_arming->addItem(tr("supervisors; others ask one each time"), toString(ArmingPolicy::Supervisors));
    return makePolicyRow(tr("Who may arm the gripper"), m_arming, &PeopleDialog::changeArming);
}

QHBoxLayout* PeopleDialog::makeApprovalRow()
{
    m_approval = new QComboBox(this);
    m_approval->setObjectName("approvalPolicy");
    m_approval->addItem(tr("any supervisor"), toString(ApprovalPolicy::OnePerson));
    m_approval->addItem(tr("a supervisor who did not enroll it"), toString(ApprovalPolicy::SecondPerson));
    return makePolicyRow(tr("Who may approve a type"), m_approval, &PeopleDialog::changeApproval);
}

QHBoxLayout* PeopleDialog::makePolicyRow(const QString& caption, QComboBox* choice,
                                         void (PeopleDialog::*change)())
{
    QLabel* label = makeLabel(caption, "caption", this);
    label->setBuddy(choice);
    choice->setAccessibleName(caption);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(label);
    row->addWidget(choice);
    row->addStretch(1);
    connect(choice, &QComboBox::activated, this, change);
    return row;
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
    m_arming->setEnabled(!m_shown.empty());
    m_arming->setCurrentIndex(m_arming->findData(toString(m_workbench->signIn().arming())));
    m_approval->setEnabled(!m_shown.empty());
    m_approval->setCurrentIndex(m_approval->findData(toString(m_workbench->signIn().approval())));
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
    m_workbench->background().ask<void>(this, std::move(work), [this, open](const Expected<void>& done) {
        const QString problem = done ? QString() : done.error().describe();
        m_state->setText(open ? QString() : problem);
        if (open && !done)
            return open->showProblem(problem);
        if (open)
            open->accept();
        m_workbench->signIn().reload();
    });
}

void PeopleDialog::changeBecause(const QString& title,
                                 std::function<Expected<void>(Library&, const QString& reason)> work)
{
    askWhy(this, title, [this, work = std::move(work)](const QString& reason) {
        authorize(*m_workbench, this, Permission::ManagePeople, [this, work, reason] {
            change([work, reason](Library& library) { return work(library, reason); });
        });
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
    changeBecause(m_role->text(), [id = person.id, role](Library& library, const QString& reason) {
        return library.people().setRole(id, role, reason);
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

void PeopleDialog::changeArming()
{
    const auto wanted = armingPolicyFromString(m_arming->currentData().toString());
    showPeople(); // as it is, until it is changed
    if (!wanted || *wanted == m_workbench->signIn().arming())
        return;
    changeBecause(tr("Change who may arm"), [policy = *wanted](Library& library, const QString& reason) {
        return library.people().setArming(policy, reason);
    });
}

void PeopleDialog::changeApproval()
{
    const auto wanted = approvalPolicyFromString(m_approval->currentData().toString());
    showPeople(); // as it is, until it is changed
    if (!wanted || *wanted == m_workbench->signIn().approval())
        return;
    changeBecause(tr("Change who may approve"), [policy = *wanted](Library& library, const QString& reason) {
        return library.people().setApproval(policy, reason);
    });
}

} // namespace gripscope
