// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/number_format.h"
#include "ui/library/library_dialog.h"
#include "ui/library/library_words.h"
#include "ui/widgets/controls.h"

#include <QDir>
#include <QGridLayout>
#include <QLineEdit>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr int width_px = 640;

const RegisteredDialog<RestoreDialog> restoreDialogRow("restore", [](Workbench&, QWidget* over) {
    RestorePlan plan;
    plan.backup = u"/media/backup/library-2026-11-24.db"_s;
    plan.holds = {4, 60, 1'204'310, 3, 4711, 12, QDateTime({2026, 11, 24}, {6, 0}, Qt::UTC)};
    plan.present = {5, 72, 1'204'722, 3, 4754, 14, QDateTime({2026, 11, 25}, {14, 12, 8}, Qt::UTC)};
    plan.kinship = Kinship::Earlier;
    return new RestoreDialog(plan, over);
});

} // namespace

RestoreDialog::RestoreDialog(const RestorePlan& plan, QWidget* parent)
    : Dialog(parent), m_reason(new QLineEdit(this))
{
    setObjectName("restoreDialog");
    setManualPage(u"library"_s);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Put back a backup"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    column->addWidget(makeLabel(tr("Put back this backup?"), "heading", this));
    QLabel* file = makeLabel(QDir::toNativeSeparators(plan.backup), "second", this);
    file->setWordWrap(true);
    column->addWidget(file);
    QLabel* whole = makeLabel(tr("It was verified: every row in it is as it was written."), "", this);
    whole->setWordWrap(true);
    column->addWidget(whole);
    column->addLayout(makeTable(plan));
    QLabel* consequence = makeLabel(LibraryWords::consequence(plan), "strong", this);
    consequence->setObjectName("restoreConsequence");
    consequence->setWordWrap(true);
    column->addWidget(consequence);
    column->addStretch(1);
    column->addWidget(makeLabel(tr("Why? The reason is kept in both libraries."), "caption", this));
    m_reason->setObjectName("restoreReason");
    m_reason->setAccessibleName(tr("Why it is put back"));
    m_reason->setMaxLength(500);
    column->addWidget(m_reason);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setObjectName("restoreCancel");
    cancel->setAutoDefault(false);
    QPushButton* yes = makeButton(tr("Put it back"), {}, "primary", this);
    yes->setObjectName("restoreAccept");
    yes->setDefault(true);
    yes->setEnabled(false);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(yes);
    column->addLayout(row);
    connect(m_reason, &QLineEdit::textChanged, this, [this, yes] { yes->setEnabled(!reason().isEmpty()); });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(yes, &QPushButton::clicked, this, &QDialog::accept);
    m_reason->setFocus();
    resize(width_px, heightForWidth(width_px));
}

QGridLayout* RestoreDialog::makeTable(const RestorePlan& plan)
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(0, 1);
    const auto add = [&](int row, const QString& name, const QString& then, const QString& now,
                         const char* role = "") {
        grid->addWidget(makeLabel(name, row == 0 ? "caption" : "", this), row, 0);
        grid->addWidget(makeLabel(then, role, this), row, 1, Qt::AlignRight);
        grid->addWidget(makeLabel(now, role, this), row, 2, Qt::AlignRight);
    };
    add(0, {}, tr("In the backup"), tr("In the library now"), "caption");
    int row = 0;
    const auto count = [&](const QString& name, qint64 LibraryContents::*of) {
        add(++row, name, formatCount(plan.holds.*of),
            plan.present ? formatCount((*plan.present).*of) : u"–"_s);
    };
    count(tr("Inspections"), &LibraryContents::inspections);
    count(tr("Squeezes"), &LibraryContents::squeezes);
    count(tr("Types"), &LibraryContents::types);
    count(tr("Calibrations"), &LibraryContents::calibrations);
    count(tr("Entries of the audit trail"), &LibraryContents::entries);
    add(++row, tr("Stored last"), LibraryWords::newest(plan.holds),
        plan.present ? LibraryWords::newest(*plan.present) : u"–"_s);
    return grid;
}

QString RestoreDialog::reason() const
{
    return m_reason->text().trimmed();
}

} // namespace gripscope
