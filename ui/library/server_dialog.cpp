// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "ui/library/library_dialog.h"
#include "ui/widgets/controls.h"

#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr int serverWidth_px = 640;

const RegisteredDialog<ServerDialog> serverDialogRow("server", [](Workbench&, QWidget* over) {
    return new ServerDialog(u"postgresql://gripscope@db.example:5432/plant?sslmode=verify-full"_s, over);
});

} // namespace

ServerDialog::ServerDialog(const QString& address, QWidget* parent)
    : Dialog(parent), m_address(new QLineEdit(address, this)), m_problem(makeLabel({}, "error", this))
{
    setObjectName("serverDialog");
    setManualPage(u"plant"_s);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Open a library on a server"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    column->addWidget(makeLabel(tr("Address of the PostgreSQL database"), "caption", this));
    m_address->setObjectName("serverAddress");
    m_address->setAccessibleName(tr("Address of the PostgreSQL database"));
    m_address->setPlaceholderText(u"postgresql://USER@HOST:PORT/DATABASE"_s);
    m_address->setMaxLength(1000);
    column->addWidget(m_address);
    QLabel* secret =
        makeLabel(tr("The password is not part of it: it is read from the file .pgpass of your home folder."),
                  "second", this);
    secret->setWordWrap(true);
    column->addWidget(secret);
    m_problem->setObjectName("serverProblem");
    m_problem->setWordWrap(true);
    column->addWidget(m_problem);
    column->addStretch(1);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setObjectName("serverCancel");
    cancel->setAutoDefault(false);
    QPushButton* open = makeButton(tr("Open"), {}, "primary", this);
    open->setObjectName("serverOpen");
    open->setDefault(true);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(open);
    column->addLayout(row);
    const auto look = [this, open] {
        const QString typed = m_address->text().trimmed();
        const Expected<QString> place = Library::placeFrom(typed);
        m_problem->setText(place || !Library::isOnServer(typed) ? QString() : place.error().describe());
        open->setEnabled(!this->address().isEmpty());
    };
    connect(m_address, &QLineEdit::textChanged, this, look);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(open, &QPushButton::clicked, this, &QDialog::accept);
    look();
    m_address->setFocus();
    resize(serverWidth_px, heightForWidth(serverWidth_px));
}

QString ServerDialog::address() const
{
    const QString typed = m_address->text().trimmed();
    return Library::isOnServer(typed) ? Library::placeFrom(typed).value_or(QString()) : QString();
}

} // namespace gripscope
