// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/settings_dialog.h"

#include "ui/people/supervised_settings.h"
#include "ui/settings/import_dialog.h"
#include "ui/settings/setting_row.h"
#include "ui/settings/settings_exchange.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QSaveFile>
#include <QScrollArea>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr qint64 mostBytes = 1'000'000; ///< no file of settings is longer

Expected<QByteArray> readFile(const QString& name)
{
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, {name, file.errorString()});
    return file.read(mostBytes);
}

Expected<void> writeFile(const QString& name, const QByteArray& bytes)
{
    QSaveFile file(name);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit())
        return {};
    return failure(ErrorCode::FileUnwritable, {name, file.errorString()});
}

} // namespace

SettingsDialog::SettingsDialog(Workbench& workbench, QWidget* parent)
    : QDialog(parent), m_workbench(&workbench)
{
    setObjectName("settingsDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Settings"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    m_search = new QLineEdit(this);
    m_search->setObjectName("settingsSearch");
    m_search->setPlaceholderText(tr("Search the settings"));
    m_search->setAccessibleName(tr("Search the settings"));
    m_search->setClearButtonEnabled(true);
    connect(m_search, &QLineEdit::textChanged, this, &SettingsDialog::filter);
    column->addWidget(m_search);
    addRows(column);
    m_told = makeLabel({}, "second", this);
    m_told->setObjectName("settingsTold");
    m_told->setWordWrap(true);
    m_told->hide();
    column->addWidget(m_told);
    addButtons(column);
    resize(880, 600);
}

void SettingsDialog::addRows(QVBoxLayout* column)
{
    QFrame* card = makeCard();
    auto* rows = new QVBoxLayout(card);
    setSpacing(rows, 16, 0);
    for (const Setting& one : allSettings()) {
        if (!one.shown)
            continue;
        if (m_groups.empty() || m_groups.back().rows.front()->setting().group != one.group) {
            auto* heading = makeLabel(settingGroupName(one.group), "heading", card);
            heading->setContentsMargins(0, m_groups.empty() ? 0 : 16, 0, 0);
            rows->addWidget(heading);
            m_groups.push_back({heading, {}});
        }
        auto* row = new SettingRow(m_workbench->settings(), one, card);
        row->setGuard([this](const SettingChange& change, std::function<void()> apply) {
            changeSettings(*m_workbench, this, {change}, std::move(apply));
        });
        m_groups.back().rows.push_back(row);
        rows->addWidget(row);
    }
    m_nothing = makeLabel(tr("No setting has these words."), "second", card);
    m_nothing->hide();
    rows->addWidget(m_nothing);
    rows->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(card);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(scroll, 1);
}

void SettingsDialog::addButtons(QVBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    const auto add = [this, row](const QString& text, const char* name, const char* role) {
        auto* button = makeButton(text, {}, role, this);
        button->setObjectName(name);
        button->setAutoDefault(false);
        row->addWidget(button);
        return button;
    };
    connect(add(tr("Export…"), "exportSettings", ""), &QPushButton::clicked, this,
            [this] { chooseFile(true); });
    connect(add(tr("Import…"), "importSettings", ""), &QPushButton::clicked, this,
            [this] { chooseFile(false); });
    connect(add(tr("Reset all…"), "resetSettings", ""), &QPushButton::clicked, this,
            &SettingsDialog::askForReset);
    row->addStretch(1);
    connect(add(tr("Close"), "closeSettings", "primary"), &QPushButton::clicked, this, &QDialog::accept);
    column->addLayout(row);
}

void SettingsDialog::filter(const QString& search)
{
    bool any = false;
    for (const Group& group : m_groups) {
        bool shown = false;
        for (SettingRow* row : group.rows) {
            row->setVisible(row->matches(search));
            shown = shown || row->matches(search);
        }
        group.heading->setVisible(shown);
        any = any || shown;
    }
    m_nothing->setVisible(!any);
}

void SettingsDialog::chooseFile(bool toSave)
{
    auto* dialog =
        new QFileDialog(this, toSave ? tr("Export the settings") : tr("Import settings"),
                        toSave ? u"gripscope-settings.json"_s : QString(), tr("Settings (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(toSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(toSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setDefaultSuffix(u"json"_s);
    connect(dialog, &QFileDialog::fileSelected, this,
            toSave ? &SettingsDialog::exportFile : &SettingsDialog::importFile);
    dialog->open();
}

void SettingsDialog::exportFile(const QString& file)
{
    m_workbench->compute<Expected<void>>(
        this, [file, bytes = exportedSettings(m_workbench->settings())] { return writeFile(file, bytes); },
        [this, file](const Expected<void>& done) {
            m_told->setText(done ? tr("The settings were written to %1.").arg(file)
                                 : done.error().describe());
            m_told->show();
        });
}

void SettingsDialog::importFile(const QString& file)
{
    m_workbench->compute<Expected<QByteArray>>(
        this, [file] { return readFile(file); },
        [this, file](const Expected<QByteArray>& bytes) {
            const Expected<SettingsImport> import =
                bytes ? readSettings(*bytes, file, m_workbench->settings())
                      : Expected<SettingsImport>(tl::unexpected<Error>(bytes.error()));
            if (!import) {
                m_told->setText(tr("%1 Nothing was changed.").arg(import.error().describe()));
                m_told->show();
                return;
            }
            auto* dialog = new ImportDialog(*import, this);
            connect(dialog, &QDialog::accepted, this, [this, file, import = *import] {
                changeSettings(*m_workbench, this, import.changes, [this, file, import] {
                    m_told->setText(tr("The settings were taken from %1.").arg(file));
                    m_told->show();
                    applyImport(m_workbench->settings(), import);
                });
            });
            dialog->open();
        });
}

void SettingsDialog::askForReset()
{
    auto* box = new QMessageBox(QMessageBox::Question, tr("Reset all settings"),
                                tr("All settings go back to their defaults. Types, squeezes and calibrations "
                                   "are not touched."),
                                QMessageBox::Cancel, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* reset = box->addButton(tr("Reset all"), QMessageBox::AcceptRole);
    connect(reset, &QPushButton::clicked, this, [this] {
        Settings& settings = m_workbench->settings();
        changeSettings(*m_workbench, this, changesOfReset(settings), [&settings] { settings.resetAll(); });
    });
    box->setDefaultButton(QMessageBox::Cancel);
    box->open();
}

} // namespace gripscope
