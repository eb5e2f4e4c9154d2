// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll/enrolled_types_dialog.h"

#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/part_picture.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// As far back as the list goes; older versions are in `gripscope-cli types versions`.
constexpr int listedVersions = 500;
constexpr int pictureSide = 32; ///< of a type in its row

QTableWidget* makeTable(const QStringList& headers, const char* name, QWidget* parent)
{
    auto* table = new QTableWidget(0, static_cast<int>(headers.size()), parent);
    table->setObjectName(QString::fromLatin1(name));
    table->setHorizontalHeaderLabels(headers);
    setUpRowList(table, 36);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    return table;
}

void setRow(QTableWidget* table, int row, const QStringList& texts)
{
    for (int column = 0; column < texts.size(); ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        item->setToolTip(texts[column]);
        table->setItem(row, column, item);
    }
}

const RegisteredDialog<EnrolledTypesDialog> enrolledTypesDialogRow("enrolled types", [](Workbench& bench,
                                                                                        QWidget* over) {
    return new EnrolledTypesDialog(bench, over);
});
} // namespace

EnrolledTypesDialog::EnrolledTypesDialog(Workbench& workbench, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench)
{
    setObjectName("enrolledTypesDialog");
    setManualPage(u"enroll"_s);
    setWindowTitle(tr("Enrolled types"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* tabs = new QTabWidget(this);
    tabs->addTab(makeTypes(), tr("Types"));
    tabs->addTab(makeVersions(), tr("Versions"));
    m_state = makeLabel({}, "caption", this);
    m_state->setObjectName("stateLabel");
    m_state->setWordWrap(true);
    QPushButton* close = makeButton(tr("Close"), {}, "primary", this);
    close->setAutoDefault(false);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_state, 1);
    foot->addWidget(close);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    column->addWidget(tabs, 1);
    column->addLayout(foot);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    resize(840, 520);
    load();
}

QPushButton* EnrolledTypesDialog::addAction(QBoxLayout* column, const QString& text, const char* name,
                                            void (EnrolledTypesDialog::*action)())
{
    QPushButton* button = makeButton(text, {}, "", this);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, action);
    column->addWidget(button);
    return button;
}

QWidget* EnrolledTypesDialog::makeTypes()
{
    auto* page = new QWidget(this);
    m_types =
        makeTable({tr("Type"), tr("State"), tr("Squeezes"), tr("Recipe"), tr("Crush limit"), tr("Code")},
                  "typesTable", page);
    m_types->setIconSize({pictureSide, pictureSide});
    m_types->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_types->setAccessibleName(tr("Enrolled types"));
    auto* actions = new QVBoxLayout;
    actions->setSpacing(8);
    m_picture = addAction(actions, tr("Picture…"), "pictureButton", &EnrolledTypesDialog::choosePicture);
    m_rename = addAction(actions, tr("Rename…"), "renameButton", &EnrolledTypesDialog::rename);
    m_code = addAction(actions, tr("Code…"), "codeButton", &EnrolledTypesDialog::editCode);
    m_limits = addAction(actions, tr("Limits…"), "limitsButton", &EnrolledTypesDialog::editLimits);
    m_merge = addAction(actions, tr("Merge…"), "mergeButton", &EnrolledTypesDialog::merge);
    m_split = addAction(actions, tr("Split…"), "splitButton", &EnrolledTypesDialog::split);
    m_approve = addAction(actions, tr("Approve"), "approveTypeButton", &EnrolledTypesDialog::approve);
    m_retire = addAction(actions, tr("Retire…"), "retireButton", &EnrolledTypesDialog::retire);
    m_putBack = addAction(actions, tr("Put back…"), "putBackButton", &EnrolledTypesDialog::putBack);
    actions->addStretch(1);
    auto* row = new QHBoxLayout(page);
    setSpacing(row, 0, 16);
    row->setContentsMargins(0, 8, 0, 0);
    row->addWidget(m_types, 1);
    row->addLayout(actions);
    connect(m_types, &QTableWidget::itemSelectionChanged, this, &EnrolledTypesDialog::refresh);
    return page;
}

QWidget* EnrolledTypesDialog::makeVersions()
{
    auto* page = new QWidget(this);
    m_versions =
        makeTable({tr("Version"), tr("When"), tr("Who"), tr("What"), tr("Why")}, "versionsTable", page);
    m_versions->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
    m_versions->setAccessibleName(tr("Versions of the library"));
    auto* actions = new QHBoxLayout;
    actions->setSpacing(8);
    m_restore = addAction(actions, tr("Restore this version…"), "restoreButton",
                          &EnrolledTypesDialog::restoreSelected);
    m_undo = addAction(actions, tr("Undo the last change…"), "undoButton", &EnrolledTypesDialog::undo);
    actions->addStretch(1);
    auto* column = new QVBoxLayout(page);
    setSpacing(column, 0, 8);
    column->setContentsMargins(0, 8, 0, 0);
    column->addWidget(m_versions, 1);
    column->addLayout(actions);
    connect(m_versions, &QTableWidget::itemSelectionChanged, this, &EnrolledTypesDialog::refresh);
    return page;
}

Expected<EnrolledTypesDialog::Contents> EnrolledTypesDialog::read(Library& library, int pictureSide)
{
    auto types = library.types();
    const auto retired = library.retiredTypes();
    auto changes = library.changes(listedVersions);
    const auto version = library.version();
    if (!types || !retired)
        return tl::unexpected<Error>((types ? retired : types).error());
    if (!changes || !version)
        return tl::unexpected<Error>(changes ? version.error() : changes.error());
    types->insert(types->end(), retired->begin(), retired->end());
    Contents contents{std::move(*types), {}, std::move(*changes), *version};
    for (const TypeRecord& type : contents.types) {
        ASSIGN_OR_RETURN(const auto picture, library.typePicture(type.id));
        contents.pictures.push_back(picture ? shownPicture(*picture, pictureSide) : QImage());
    }
    return contents;
}

void EnrolledTypesDialog::load()
{
    m_workbench->background().ask<Contents>(
        this,
        [side = static_cast<int>(pictureSide * devicePixelRatioF())](Library& library) {
            return read(library, side);
        },
        [this](Expected<Contents> contents) {
            if (contents)
                show(std::move(*contents));
            else
                m_state->setText(contents.error().describe());
        });
}

void EnrolledTypesDialog::show(Contents contents)
{
    const int selected = m_types->currentRow();
    m_contents = std::move(contents);
    m_types->setRowCount(static_cast<int>(m_contents.types.size()));
    for (int row = 0; row < m_types->rowCount(); ++row) {
        const TypeRecord& type = m_contents.types[static_cast<std::size_t>(row)];
        const QString state = type.status == TypeStatus::Retired    ? tr("retired")
                              : type.status == TypeStatus::Approved ? tr("approved")
                                                                    : tr("not approved");
        setRow(m_types, row,
               {type.name, state, QString::number(type.squeezes), type.recipe.name,
                forceText(type.recipe.maxForce_N), type.code});
        if (const QImage& picture = m_contents.pictures[static_cast<std::size_t>(row)]; !picture.isNull())
            m_types->item(row, 0)->setIcon(QPixmap::fromImage(picture));
    }
    m_versions->setRowCount(static_cast<int>(m_contents.changes.size()));
    for (int row = 0; row < m_versions->rowCount(); ++row) {
        const LibraryChange& change = m_contents.changes[static_cast<std::size_t>(row)];
        setRow(m_versions, row,
               {QString::number(change.version), timeText(change.changed), change.operatorName,
                inWords(change), change.reason});
    }
    if (selected >= 0 && selected < m_types->rowCount())
        m_types->selectRow(selected);
    m_state->setText(
        m_contents.changes.empty()
            ? tr("Nothing is enrolled yet.")
            : tr("Version %1: %2").arg(m_contents.version).arg(inWords(m_contents.changes.front())));
    refresh();
}

void EnrolledTypesDialog::refresh()
{
    const TypeRecord* type = selectedType();
    const bool inUse = type && type->status != TypeStatus::Retired;
    m_picture->setEnabled(type);
    m_rename->setEnabled(type);
    m_code->setEnabled(type);
    m_limits->setEnabled(inUse);
    m_merge->setEnabled(inUse && m_contents.types.size() > 1);
    m_split->setEnabled(inUse && type->squeezes > 1);
    m_approve->setEnabled(inUse && type->status != TypeStatus::Approved);
    m_retire->setEnabled(inUse);
    m_putBack->setEnabled(type && !inUse);
    const LibraryChange* version = selectedVersion();
    m_restore->setEnabled(version && version->version < m_contents.version);
    m_undo->setEnabled(m_contents.version > 0);
}

const TypeRecord* EnrolledTypesDialog::selectedType() const
{
    const QModelIndexList rows = m_types->selectionModel()->selectedRows();
    return rows.isEmpty() ? nullptr : &m_contents.types[static_cast<std::size_t>(rows.first().row())];
}

const LibraryChange* EnrolledTypesDialog::selectedVersion() const
{
    const QModelIndexList rows = m_versions->selectionModel()->selectedRows();
    return rows.isEmpty() ? nullptr : &m_contents.changes[static_cast<std::size_t>(rows.first().row())];
}

} // namespace gripscope
