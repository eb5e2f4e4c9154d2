// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/batch_dialog.h"

#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

namespace gripscope {

namespace {
constexpr int usualTarget = 100;
}

BatchDialog::BatchDialog(const QString& expectedType, QWidget* parent)
    : QDialog(parent), m_expectedType(expectedType), m_name(new QLineEdit(this)),
      m_target(new QSpinBox(this)), m_accept(makeButton(tr("Begin the batch"), {}, "primary", this))
{
    setObjectName("batchDialog");
    setWindowTitle(tr("Begin a batch"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_name->setObjectName("batchNameField");
    m_name->setMaxLength(longestBatchName);
    m_name->setAccessibleName(tr("Name or number of the batch"));
    m_target->setObjectName("batchTargetField");
    m_target->setRange(1, static_cast<int>(largestBatch));
    m_target->setValue(usualTarget);
    m_target->setAccessibleName(tr("Parts wanted"));
    QLabel* counts = makeLabel(
        expectedType.isEmpty()
            ? tr("Each part that is one of the enrolled types counts, since no type is expected. Other parts "
                 "and measurements that are not valid do not count. The batch ends by itself.")
            : tr("Parts that are %1 count. Other parts and measurements that are not valid do not count. The "
                 "batch ends by itself.")
                  .arg(expectedType),
        "second", this);
    counts->setWordWrap(true);
    m_accept->setObjectName("batchAccept");
    m_accept->setAutoDefault(false); // a scanned number ends with Enter, and begins nothing yet
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_accept);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 8);
    column->addWidget(makeLabel(tr("Begin a batch"), "heading", this));
    column->addWidget(makeLabel(tr("Name or number"), "caption", this));
    column->addWidget(m_name);
    column->addWidget(makeLabel(tr("Parts wanted, as expected"), "caption", this));
    column->addWidget(m_target);
    column->addSpacing(8);
    column->addWidget(counts);
    column->addSpacing(8);
    column->addLayout(buttons);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_name, &QLineEdit::textChanged, this, &BatchDialog::refresh);
    connect(m_name, &QLineEdit::returnPressed, this, [this] {
        m_target->setFocus();
        m_target->selectAll();
    });
    resize(440, sizeHint().height());
    m_name->setFocus();
    refresh();
}

NewBatch BatchDialog::batch() const
{
    return {m_name->text().trimmed(), m_target->value(), m_expectedType, {}};
}

void BatchDialog::refresh()
{
    m_accept->setEnabled(!batch().name.isEmpty());
}

} // namespace gripscope
