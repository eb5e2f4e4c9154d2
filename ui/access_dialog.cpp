// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/access_dialog.h"

#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

AccessDialog::AccessDialog(Workbench& workbench, const FoundDevice& device, QWidget* parent) : QDialog(parent)
{
    setObjectName("accessDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Allow access to the gripper"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 16);
    column->addWidget(makeLabel(tr("This user may not open %1").arg(device.name), "heading", this));
    auto* what =
        makeLabel(tr("Type this in a terminal, once on this computer. It asks for the password of an "
                     "administrator. Gripscope then connects the gripper by itself."),
                  "", this);
    what->setWordWrap(true);
    column->addWidget(what);

    const QString text = device.toAllow.join(u'\n');
    auto* commands = new QPlainTextEdit(text, this);
    commands->setObjectName("accessCommands");
    commands->setAccessibleName(tr("Commands to type"));
    commands->setReadOnly(true);
    commands->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    commands->setMinimumHeight(152);
    column->addWidget(commands, 1);

    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    auto* copy = makeButton(tr("Copy"), u"edit-copy"_s, "primary", this);
    connect(copy, &QPushButton::clicked, this,
            [text] { QGuiApplication::clipboard()->setText(text + u'\n'); });
    auto* close = makeButton(tr("Close"), {}, "", this);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    row->addStretch(1);
    row->addWidget(close);
    row->addWidget(copy);
    column->addLayout(row);
    resize(720, 360);
    connect(&workbench, &Workbench::connectionChanged, this, [this, bench = &workbench] {
        if (bench->connection().state() == ConnectSession::State::Connected)
            accept();
    });
}

} // namespace gripscope
