// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/import_dialog.h"

#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

QString verdict(const SettingsImport& import)
{
    if (!import.errors.isEmpty())
        return ImportDialog::tr("The file has values that cannot be used, so nothing of it is taken.");
    if (import.changes.empty())
        return ImportDialog::tr("The file changes nothing: all settings are as they are in it.");
    return ImportDialog::tr("These settings change:");
}

} // namespace

ImportDialog::ImportDialog(const SettingsImport& import, QWidget* parent) : QDialog(parent)
{
    setObjectName("importDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Import settings"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 16);
    auto* heading = makeLabel(verdict(import), "strong", this);
    heading->setWordWrap(true);
    column->addWidget(heading);
    if (const QStringList problems = import.errors + import.notes; !problems.isEmpty()) {
        auto* list = makeLabel(problems.join(u'\n'), import.errors.isEmpty() ? "second" : "error", this);
        list->setObjectName("importProblems");
        list->setTextFormat(Qt::PlainText);
        list->setWordWrap(true);
        column->addWidget(list);
    }
    if (import.errors.isEmpty() && !import.changes.empty())
        column->addWidget(makeTable(import), 1);
    else
        column->addStretch(1);

    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch(1);
    auto* cancel = makeButton(tr("Cancel"), {}, "", this);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    auto* apply = makeButton(tr("Apply"), {}, "primary", this);
    apply->setObjectName("applyImport");
    apply->setEnabled(import.errors.isEmpty() && !import.changes.empty());
    connect(apply, &QPushButton::clicked, this, &QDialog::accept);
    row->addWidget(cancel);
    row->addWidget(apply);
    column->addLayout(row);
    resize(720, 440);
}

QWidget* ImportDialog::makeTable(const SettingsImport& import)
{
    auto* table = new QTableWidget(static_cast<int>(import.changes.size()), 3, this);
    table->setObjectName("importTable");
    table->setAccessibleName(tr("What changes"));
    table->setHorizontalHeaderLabels({tr("Setting"), tr("Now"), tr("From the file")});
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->verticalHeader()->hide();
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    int row = 0;
    for (const SettingChange& change : import.changes) {
        const Setting* one = findSetting(change.key);
        const QString cells[] = {one->shownName(), one->shownValue(change.before),
                                 one->shownValue(change.after)};
        for (int i = 0; i < 3; ++i)
            table->setItem(row, i, new QTableWidgetItem(cells[i]));
        ++row;
    }
    return table;
}

} // namespace gripscope
