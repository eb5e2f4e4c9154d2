// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect/void_dialog.h"

#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

namespace gripscope {

namespace {
constexpr int longestReason = 200;
constexpr int dialogWidth = 480;

const RegisteredDialog<VoidDialog> voidDialogRow("void", [](Workbench&, QWidget* over) {
    return new VoidDialog(1, over);
});
} // namespace

VoidDialog::VoidDialog(qint64 number, QWidget* parent)
    : Dialog(parent), m_reason(new QLineEdit(this)), m_accept(makeButton(tr("Void it"), {}, "primary", this))
{
    setObjectName("voidDialog");
    const QString title = tr("Void inspection %1").arg(number);
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    QLabel* words = makeLabel(tr("It stays on record with the reason, and counts neither in the yield nor in "
                                 "the batch. This cannot be undone."),
                              "second", this);
    words->setWordWrap(true);
    QPushButton* twice = makeButton(tr("Squeezed twice"), {}, "", this);
    twice->setObjectName("voidTwice");
    QPushButton* empty = makeButton(tr("Nothing in the jaws"), {}, "", this);
    empty->setObjectName("voidEmpty");
    m_reason->setObjectName("voidReason");
    m_reason->setMaxLength(longestReason);
    m_reason->setPlaceholderText(tr("or why else"));
    m_reason->setAccessibleName(tr("Why it does not count"));
    m_accept->setObjectName("voidAccept");
    m_accept->setEnabled(false);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    for (QPushButton* button : {twice, empty, cancel, m_accept})
        button->setAutoDefault(false); // a scanner's Enter voids nothing
    auto* reasons = new QHBoxLayout;
    reasons->setSpacing(8);
    reasons->addWidget(twice, 1);
    reasons->addWidget(empty, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_accept);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    column->addWidget(makeLabel(title, "heading", this));
    column->addWidget(words);
    column->addLayout(reasons);
    column->addWidget(m_reason);
    column->addStretch(1);
    column->addLayout(buttons);
    connect(twice, &QPushButton::clicked, this, [this, twice] { give(twice->text()); });
    connect(empty, &QPushButton::clicked, this, [this, empty] { give(empty->text()); });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, [this] { give(m_reason->text()); });
    connect(m_reason, &QLineEdit::textChanged, this,
            [this](const QString& text) { m_accept->setEnabled(!text.trimmed().isEmpty()); });
    resize(dialogWidth, layout()->totalHeightForWidth(dialogWidth));
    m_reason->setFocus();
}

void VoidDialog::give(const QString& reason)
{
    emit answered(reason.trimmed());
    accept();
}

} // namespace gripscope
