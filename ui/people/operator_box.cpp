// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/operator_box.h"

#include "ui/people/audit_dialog.h"
#include "ui/people/people_dialog.h"
#include "ui/people/sign_in.h"
#include "ui/people/sign_in_dialog.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>

using namespace Qt::StringLiterals;

namespace gripscope {

OperatorBox::OperatorBox(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_caption(makeLabel(tr("Operator"), "caption", this)),
      m_name(new QLineEdit(this)), m_chip(makeButton({}, u"user"_s, "", this)), m_menu(new QMenu(this))
{
    makeField();
    m_chip->setObjectName("operatorChip");
    m_menu->setObjectName("operatorMenu");
    m_menu->setAccessibleName(tr("People"));
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 8);
    row->addWidget(m_caption);
    row->addWidget(m_name);
    row->addWidget(m_chip);
    connect(m_chip, &QPushButton::clicked, this, [this] {
        m_workbench->signIn().reload(); // somebody may have been added elsewhere
        fillMenu();
        m_menu->popup(m_chip->mapToGlobal(QPoint(0, m_chip->height() + 4)));
    });
    connect(&workbench.signIn(), &SignIn::changed, this, &OperatorBox::refresh);
    refresh();
}

void OperatorBox::makeField()
{
    m_name->setObjectName("operatorField");
    m_name->setPlaceholderText(tr("name"));
    m_name->setAccessibleName(tr("Operator"));
    m_name->setToolTip(tr("Who works here: kept with every squeeze"));
    m_name->setMaxLength(80);
    m_name->setFixedWidth(120);
    m_name->setText(m_workbench->operatorName());
    m_caption->setBuddy(m_name);
    connect(m_name, &QLineEdit::textEdited, this,
            [this](const QString& text) { m_workbench->setOperatorName(text.trimmed()); });
    connect(m_workbench, &Workbench::operatorChanged, this, [this] {
        if (m_name->text().trimmed() != m_workbench->operatorName())
            m_name->setText(m_workbench->operatorName());
    });
}

void OperatorBox::refresh()
{
    const SignIn& signIn = m_workbench->signIn();
    const std::optional<Authority>& who = signIn.current();
    m_name->setVisible(!signIn.inForce());
    m_caption->setVisible(!signIn.inForce());
    // A long name gives way to the gripper beside it.
    constexpr int roomForName = 150;
    const QString name =
        who ? m_chip->fontMetrics().elidedText(who->name(), Qt::ElideRight, roomForName) : tr("Sign in");
    m_chip->setText(signIn.inForce() ? name : QString());
    m_chip->setFixedWidth(signIn.inForce() ? QWIDGETSIZE_MAX : 56);
    m_chip->setMinimumWidth(signIn.inForce() ? 0 : 56);
    m_chip->setAccessibleName(!signIn.inForce() ? tr("People")
                              : who             ? tr("%1, %2").arg(who->name(), inWords(who->role()))
                                                : tr("Nobody has signed in"));
    m_chip->setToolTip(signIn.inForce() ? m_chip->accessibleName() : tr("People and the audit trail"));
}

void OperatorBox::fillMenu()
{
    const SignIn& signIn = m_workbench->signIn();
    QWidget* over = window();
    m_menu->clear();
    const auto add = [this](const QString& text, const char* name, auto action) {
        QAction* entry = m_menu->addAction(text);
        entry->setObjectName(QString::fromLatin1(name));
        connect(entry, &QAction::triggered, this, action);
    };
    if (signIn.inForce()) {
        add(signIn.current() ? tr("Sign in as somebody else…") : tr("Sign in…"), "signInAction",
            [this, over] { (new SignInDialog(*m_workbench, std::nullopt, over))->open(); });
        if (signIn.current())
            add(tr("Sign out"), "signOutAction", [this] { m_workbench->signIn().signOut(); });
        m_menu->addSeparator();
    }
    add(tr("People…"), "peopleAction", [this, over] { (new PeopleDialog(*m_workbench, over))->open(); });
    add(tr("Audit trail…"), "auditAction", [this, over] { (new AuditDialog(*m_workbench, over))->open(); });
}

} // namespace gripscope
