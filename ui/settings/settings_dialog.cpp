// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/settings_dialog.h"

#include "core/base/bounded_file.h"
#include "ui/context/workbench.h"
#include "ui/people/authorize.h"
#include "ui/settings/values/settings_exchange.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/windows/file_dialog.h"
#include "ui/windows/question.h"

#include <QFile>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString verdict(const SettingsImport& import)
{
    if (!import.errors.isEmpty())
        return ImportDialog::tr("The file has values that cannot be used, so nothing of it is taken.");
    if (import.changes.empty())
        return ImportDialog::tr("The file changes nothing: all settings are as they are in it.");
    return ImportDialog::tr("These settings change:");
}

const RegisteredDialog<ImportDialog> importDialogRow("import", [](Workbench&, QWidget* over) {
    return new ImportDialog({}, over);
});
} // namespace

ImportDialog::ImportDialog(const SettingsImport& import, QWidget* parent) : Dialog(parent)
{
    setObjectName("importDialog");
    setManualPage(u"settings"_s);
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

namespace {

constexpr qint64 mostBytes = 1'000'000; ///< no file of settings is longer

Expected<QByteArray> readFile(const QString& name)
{
    return readBounded(name, mostBytes);
}

const RegisteredDialog<SettingsDialog> settingsDialogRow("settings", [](Workbench& bench, QWidget* over) {
    return new SettingsDialog(bench, over);
});
} // namespace

SettingsDialog::SettingsDialog(Workbench& workbench, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench)
{
    setObjectName("settingsDialog");
    setManualPage(u"settings"_s);
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
        row->setTeller([this](const QString& words) { tell(words, "error"); });
        m_groups.back().rows.push_back(row);
        rows->addWidget(row);
    }
    m_nothing = makeLabel(tr("No setting has these words."), "second", card);
    m_nothing->hide();
    rows->addWidget(m_nothing);
    rows->addStretch(1);
    column->addWidget(makeScroll(card, this), 1);
}

void SettingsDialog::tell(const QString& words, const char* role)
{
    setRole(m_told, role);
    m_told->setText(words);
    m_told->setVisible(!words.isEmpty());
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
    auto* dialog = new FileDialog(this, toSave ? tr("Export the settings") : tr("Import settings"),
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
    m_workbench->background().compute<Expected<void>>(
        this, [file, bytes = exportedSettings(m_workbench->settings())] { return writeWhole(file, bytes); },
        [this, file](const Expected<void>& done) {
            tell(done ? tr("The settings were written to %1.").arg(file) : done.error().describe());
        });
}

void SettingsDialog::importFile(const QString& file)
{
    m_workbench->background().compute<Expected<QByteArray>>(
        this, [file] { return readFile(file); },
        [this, file](const Expected<QByteArray>& bytes) {
            const Expected<SettingsImport> import =
                bytes ? readSettings(*bytes, file, m_workbench->settings())
                      : Expected<SettingsImport>(tl::unexpected<Error>(bytes.error()));
            if (!import) {
                tell(tr("%1 Nothing was changed.").arg(import.error().describe()));
                return;
            }
            auto* dialog = new ImportDialog(*import, this);
            connect(dialog, &QDialog::accepted, this, [this, file, import = *import] {
                changeSettings(*m_workbench, this, import.changes, [this, file, import] {
                    tell(tr("The settings were taken from %1.").arg(file));
                    applyImport(m_workbench->settings(), import);
                });
            });
            dialog->open();
        });
}

void SettingsDialog::askForReset()
{
    auto* question =
        new Question(tr("Reset all settings"),
                     tr("All settings go back to their defaults. Types, squeezes and calibrations "
                        "are not touched."),
                     tr("Reset all"), tr("Cancel"), this);
    connect(question, &QDialog::accepted, this, [this] {
        Settings& settings = m_workbench->settings();
        changeSettings(*m_workbench, this, changesOfReset(settings), [&settings] { settings.resetAll(); });
    });
    question->open();
}

} // namespace gripscope
