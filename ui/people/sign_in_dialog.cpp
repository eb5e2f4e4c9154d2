// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/sign_in_dialog.h"

#include "ui/context/sign_in.h"
#include "ui/context/workbench.h"
#include "ui/people/secret_field.h"
#include "ui/widgets/controls.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
const RegisteredDialog<SignInDialog> signInDialogRow("sign in", [](Workbench& bench, QWidget* over) {
    return new SignInDialog(bench, std::nullopt, over);
});
} // namespace

SignInDialog::SignInDialog(Workbench& workbench, std::optional<Permission> permission, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench), m_permission(permission), m_person(new QComboBox(this)),
      m_secret(makeSecretField(tr("PIN or password"), this)),
      m_accept(makeButton(permission ? tr("Authorise") : tr("Sign in"), {}, "primary", this))
{
    setObjectName("signInDialog");
    setManualPage(u"people"_s);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(permission ? tr("Supervisor needed") : tr("Sign in"));
    m_person->setObjectName("personField");
    m_person->setAccessibleName(permission ? tr("Supervisor") : tr("Person"));
    m_secret->setObjectName("secretField");
    m_accept->setObjectName("signInAccept");
    m_accept->setDefault(true);
    m_state = makeLabel({}, "error", this);
    m_state->setObjectName("signInState");
    m_state->setWordWrap(true);
    // Room for the longest answer, so that nothing moves under the finger.
    m_state->setMinimumHeight(3 * fontMetrics().lineSpacing());
    m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);

    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 8);
    column->addWidget(makeLabel(windowTitle(), "heading", this));
    if (permission) {
        column->addWidget(makeLabel(inWords(*permission), "strong", this));
        QLabel* words =
            makeLabel(tr("A supervisor allows this one time. It is kept with both names."), "second", this);
        words->setWordWrap(true);
        column->addWidget(words);
    }
    column->addSpacing(8);
    column->addWidget(makeLabel(m_person->accessibleName(), "caption", this));
    column->addWidget(m_person);
    column->addSpacing(4);
    column->addWidget(makeLabel(m_secret->accessibleName(), "caption", this));
    column->addWidget(m_secret);
    column->addWidget(m_state, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setAutoDefault(false);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(m_accept);
    column->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, &SignInDialog::check);
    connect(m_secret, &QLineEdit::textChanged, this, &SignInDialog::refresh);
    connect(m_person, &QComboBox::currentIndexChanged, this, &SignInDialog::refresh);
    connect(&workbench.signIn(), &SignIn::changed, this, &SignInDialog::fill);
    resize(440, sizeHint().height());
    fill();
    m_secret->setFocus();
}

void SignInDialog::fill()
{
    const QString chosen = m_person->currentData().toString();
    m_person->clear();
    for (const Person& person : m_workbench->signIn().people())
        if (person.active &&
            (!m_permission || mayDo(person.role, *m_permission, m_workbench->signIn().arming())))
            m_person->addItem(person.name, person.id);
    m_person->setCurrentIndex(std::max(0, m_person->findData(chosen)));
    refresh();
}

void SignInDialog::refresh()
{
    m_accept->setEnabled(!m_checking && m_person->currentIndex() >= 0 && !m_secret->text().isEmpty());
}

void SignInDialog::check()
{
    m_checking = true;
    m_state->clear();
    const QString person = m_person->currentData().toString();
    Secret secret = takeSecret(*m_secret);
    refresh();
    if (!m_permission) {
        m_workbench->signIn().signIn(this, person, std::move(secret),
                                     [this](const std::optional<QString>& problem) { finish(problem); });
        return;
    }
    m_workbench->signIn().authorise(
        this, person, std::move(secret), *m_permission, [this](const Expected<Grant>& grant) {
            if (grant)
                emit authorised(*grant);
            finish(grant ? std::nullopt : std::optional(grant.error().describe()));
        });
}

void SignInDialog::finish(const std::optional<QString>& problem)
{
    m_checking = false;
    if (!problem)
        return accept();
    m_state->setText(*problem);
    m_secret->setFocus();
    refresh();
}

} // namespace gripscope
