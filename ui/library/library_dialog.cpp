// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/library/library_dialog.h"

#include "core/library/backup/library_backup.h"
#include "core/library/backup/server_copies.h"
#include "core/library/library.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/library/library_words.h"
#include "ui/library/recent_libraries.h"
#include "ui/library/station_conflicts.h"
#include "ui/pages/page.h"
#include "ui/people/authorize.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/controls.h"
#include "ui/windows/file_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QListWidget>
#include <QPointer>
#include <QProgressBar>
#include <QVBoxLayout>

#include <algorithm>
#include <atomic>

namespace gripscope {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr int steps = 1000; ///< of the progress

const RegisteredDialog<LibraryDialog> libraryDialogRow("library", [](Workbench& bench, QWidget* over) {
    return new LibraryDialog(bench, over);
});

} // namespace

struct LibraryDialog::Work {
    std::atomic<int> done = 0;
    std::atomic<bool> cancelled = false;

    static CopyProgress progress(const std::shared_ptr<Work>& work)
    {
        return [work](double share) {
            work->done = static_cast<int>(share * steps);
            return !work->cancelled;
        };
    }
};

LibraryDialog::LibraryDialog(Workbench& workbench, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench), m_contents(makeLabel({}, "second", this)),
      m_state(makeLabel({}, "", this)), m_recent(new QListWidget(this)),
      m_cancel(makeButton(tr("Cancel"), {}, "", this)), m_progress(new QProgressBar(this))
{
    setObjectName("libraryDialog");
    setManualPage(u"library"_s);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Library"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    QLabel* file = makeLabel(QDir::toNativeSeparators(workbench.library().file()), "strong", this);
    file->setObjectName("libraryFile");
    file->setWordWrap(true);
    column->addWidget(file);
    m_contents->setObjectName("libraryContents");
    m_contents->setWordWrap(true);
    column->addWidget(m_contents);
    column->addLayout(makeActions());
    column->addWidget(new StationConflicts(workbench, this));
    column->addWidget(makeLabel(tr("Opened before"), "caption", this));
    m_recent->setObjectName("recentLibraries");
    m_recent->setAccessibleName(tr("Libraries that were opened before"));
    m_recent->setToolTip(tr("Double-click, or Enter, opens it"));
    addRecent();
    column->addWidget(m_recent, 1);
    m_state->setObjectName("libraryState");
    m_state->setWordWrap(true);
    m_state->hide();
    column->addWidget(m_state);
    column->addLayout(makeFoot());
    connect(m_recent, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { openLibrary(item->data(Qt::UserRole).toString()); });
    m_look.setInterval(100ms);
    connect(&m_look, &QTimer::timeout, this, &LibraryDialog::showProgress);
    resize(720, 480);
    reload();
}

LibraryDialog::~LibraryDialog()
{
    if (m_work)
        m_work->cancelled = true;
    if (m_plan)
        m_workbench->background().compute<bool>(
            nullptr,
            [plan = *m_plan] {
                discard(plan);
                return true;
            },
            [](bool) {});
}

QHBoxLayout* LibraryDialog::makeActions()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    const auto add = [&](const QString& text, const QString& icon, const char* name, auto action) {
        QPushButton* button = makeButton(text, icon, "", this);
        button->setObjectName(name);
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, action);
        row->addWidget(button);
        return button;
    };
    m_open = add(tr("Open another…"), u"document-open"_s, "libraryOpen", &LibraryDialog::chooseToOpen);
    m_server = add(tr("On a server…"), {}, "libraryServer", &LibraryDialog::chooseServer);
    m_server->setToolTip(tr("Opens a library that is a PostgreSQL database"));
    m_backUp = add(tr("Back up…"), u"document-save"_s, "libraryBackUp", &LibraryDialog::chooseBackup);
    m_backUp->setToolTip(tr("A copy of all of it, verified; work goes on meanwhile"));
    m_restore = add(tr("Put back a backup…"), {}, "libraryRestore", &LibraryDialog::chooseToRestore);
    m_restore->setToolTip(tr("Shows what is in it before anything is changed"));
    row->addStretch(1);
    return row;
}

QHBoxLayout* LibraryDialog::makeFoot()
{
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->hide();
    m_cancel->setObjectName("libraryCancel");
    m_cancel->setAutoDefault(false);
    m_cancel->hide();
    QPushButton* close = makeButton(tr("Close"), {}, "primary", this);
    close->setObjectName("libraryClose");
    close->setAutoDefault(false);
    auto* foot = new QHBoxLayout;
    foot->setSpacing(8);
    foot->addWidget(m_progress, 1);
    foot->addStretch(0);
    foot->addWidget(m_cancel);
    foot->addWidget(close, 0, Qt::AlignRight);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_work)
            m_work->cancelled = true;
        m_cancel->setEnabled(false);
    });
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    return foot;
}

void LibraryDialog::addRecent()
{
    const QString open = m_workbench->library().file();
    for (const QString& file : recentLibraries(m_workbench->settings())) {
        if (file == (Library::isOnServer(open) ? open : QFileInfo(open).absoluteFilePath()))
            continue;
        auto* item = new QListWidgetItem(QDir::toNativeSeparators(file), m_recent);
        item->setData(Qt::UserRole, file);
    }
}

void LibraryDialog::reload()
{
    m_contents->setText(tr("Counting…"));
    m_workbench->background().compute<Expected<LibraryContents>>(
        this, [file = m_workbench->library().file()] { return contentsOfLibrary(file); },
        [this](const Expected<LibraryContents>& found) {
            m_contents->setText(found ? LibraryWords::contents(*found) : found.error().describe());
        });
}

bool LibraryDialog::mayLeave()
{
    const std::size_t unstored = m_workbench->inspection().unstored();
    const bool squeezing =
        m_workbench->squeezing() || m_workbench->inspection().state() == InspectSession::State::Judging;
    const QWidget* owner = parentWidget();
    const QList<Page*> pages = owner ? owner->window()->findChildren<Page*>() : QList<Page*>();
    const bool underWay =
        std::any_of(pages.begin(), pages.end(), [](const Page* page) { return page->underWay(); });
    if (squeezing)
        tell(tr("A squeeze is under way. Wait for its end, then try again."), "error");
    else if (underWay)
        tell(tr("A calibration is under way. Accept or leave it, then try again."), "error");
    else if (unstored > 0)
        tell(tr("Inspections that are not stored yet: %1. Wait until they are, then try again.")
                 .arg(formatCount(static_cast<qint64>(unstored))),
             "error");
    return !squeezing && !underWay && unstored == 0;
}

void LibraryDialog::tell(const QString& words, const char* role)
{
    setRole(m_state, role);
    m_state->setText(words);
    m_state->show();
}

void LibraryDialog::begin(const QString& words)
{
    m_work = std::make_shared<Work>();
    tell(words, "second");
    for (QWidget* one : actions())
        one->setEnabled(false);
    m_cancel->setEnabled(true);
    m_cancel->show();
    m_progress->show();
    m_look.start();
    showProgress();
}

QList<QWidget*> LibraryDialog::actions() const
{
    return {m_open, m_server, m_backUp, m_restore, m_recent};
}

/// Where files are asked for; of a library on a server, the user's own.
QString LibraryDialog::folderOfLibrary() const
{
    const QString place = m_workbench->library().file();
    return Library::isOnServer(place) ? QDir::homePath() : QFileInfo(place).absolutePath();
}

void LibraryDialog::end()
{
    m_work.reset();
    m_look.stop();
    m_progress->hide();
    m_cancel->hide();
    for (QWidget* one : actions())
        one->setEnabled(true);
}

/// Copied, it is verified, and nobody knows how long that takes.
void LibraryDialog::showProgress()
{
    const int done = m_work ? m_work->done.load() : 0;
    m_progress->setRange(0, done < steps ? steps : 0);
    m_progress->setValue(done);
    if (done >= steps)
        m_state->setText(tr("Copied. Verifying every row of the copy…"));
}

void LibraryDialog::chooseToOpen()
{
    auto* dialog = new FileDialog(this, tr("Open another library"), folderOfLibrary(),
                                  tr("Libraries (*.db *.gripscope);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &LibraryDialog::openLibrary);
    dialog->open();
}

void LibraryDialog::chooseServer()
{
    const QString place = m_workbench->library().file();
    auto* dialog = new ServerDialog(Library::isOnServer(place) ? place : QString(), this);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { openLibrary(dialog->address()); });
    dialog->open();
}

void LibraryDialog::openLibrary(const QString& place)
{
    if (m_work || !mayLeave())
        return;
    tell(tr("Opening…"), "second");
    m_workbench->background().compute<Expected<void>>(
        this,
        [place]() -> Expected<void> {
            ASSIGN_OR_RETURN(const bool isThere, Library::isThere(place));
            if (!isThere) // none is made here
                return failure(ErrorCode::StorageOpen, {place, tr("there is no such file")});
            if (!Library::isOnServer(place) && QFileInfo(place).size() == 0) // it would become one
                return failure(ErrorCode::StorageOpen, {place, tr("there is nothing in it")});
            return Library::open(place).map([](const std::unique_ptr<Library>&) {});
        },
        [this, place](const Expected<void>& opened) {
            if (!opened)
                return tell(opened.error().describe(), "error");
            if (mayLeave())
                m_workbench->navigator().openLibrary(
                    place, tr("The library %1 is open.").arg(QDir::toNativeSeparators(place)));
        });
}

void LibraryDialog::chooseBackup()
{
    const QString library = m_workbench->library().file();
    if (const auto otherwise = copiedByServer(library, u"library.dump"_s))
        return tell(otherwise->describe(), "error");
    auto* dialog = new FileDialog(this, tr("Back up the library"), QFileInfo(library).absolutePath(),
                                  tr("All files (*)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite); // it is never overwritten
    dialog->selectFile(backupName(library, QDate::currentDate()));
    connect(dialog, &QFileDialog::fileSelected, this, &LibraryDialog::backUpTo);
    dialog->open();
}

void LibraryDialog::backUpTo(const QString& file)
{
    if (m_work)
        return;
    begin(tr("Copying the library…"));
    // Told to the audit trail though the dialog may be gone by then.
    m_workbench->background().compute<Expected<LibraryBackup>>(
        m_workbench,
        [library = m_workbench->library().file(), file, progress = Work::progress(m_work)] {
            return backUpLibrary(library, file, progress);
        },
        [bench = m_workbench, file, self = QPointer(this)](const Expected<LibraryBackup>& made) {
            if (self)
                self->end();
            if (made)
                bench->background().ask<void>(
                    bench,
                    [file, rows = made->verified.rows](Library& library) {
                        return library.tellBackup(file, rows);
                    },
                    [bench](const Expected<void>& told) {
                        if (!told)
                            bench->messages().report(told.error().describe());
                    });
            if (!self)
                return;
            if (!made)
                return self->tell(made.error().describe(), "error");
            if (!made->verified.whole())
                return self->tell(tr("The backup was written, but it holds what the library holds: %1")
                                      .arg(inWords(made->verified)),
                                  "error");
            self->tell(tr("The backup %1 was written and verified. %2")
                           .arg(QDir::toNativeSeparators(file), LibraryWords::contents(made->contents)),
                       "strong");
        });
}

void LibraryDialog::chooseToRestore()
{
    if (const auto otherwise = putBackByServer(m_workbench->library().file(), u"library.dump"_s))
        return tell(otherwise->describe(), "error");
    auto* dialog = new FileDialog(this, tr("Put back a backup"), folderOfLibrary(), tr("All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &LibraryDialog::restoreFrom);
    dialog->open();
}

void LibraryDialog::restoreFrom(const QString& file)
{
    if (m_work || !mayLeave())
        return;
    m_plan.reset(); // what was prepared before is removed by what follows
    begin(tr("Copying the backup beside the library, to verify it…"));
    m_workbench->background().compute<Expected<RestorePlan>>(
        this,
        [library = m_workbench->library().file(), file, progress = Work::progress(m_work)] {
            return prepareRestore(library, file, progress);
        },
        [this](const Expected<RestorePlan>& plan) {
            end();
            if (!plan)
                return tell(plan.error().describe(), "error");
            m_state->hide();
            askToRestore(*plan);
        });
}

void LibraryDialog::askToRestore(const RestorePlan& plan)
{
    m_plan = plan;
    auto* dialog = new RestoreDialog(plan, this);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        authorize(*m_workbench, this, Permission::RestoreLibrary,
                  [this, why = dialog->reason()] { restore(why); });
    });
    dialog->open();
}

void LibraryDialog::restore(const QString& reason)
{
    if (!m_plan || !mayLeave())
        return;
    const RestorePlan plan = *std::exchange(m_plan, std::nullopt);
    m_workbench->stop(); // nothing moves while the library changes
    begin(tr("Putting it back…"));
    m_cancel->hide(); // a moment
    m_workbench->background().askClosed<QString>(
        m_workbench, [plan, reason](const Acting& acting) { return restoreLibrary(plan, acting, reason); },
        [bench = m_workbench, plan, self = QPointer(this)](const Expected<QString>& keptAs) {
            if (self)
                self->end();
            if (keptAs)
                return bench->navigator().openLibrary(
                    plan.library, tr("The backup was put back. The library of before is kept as %1.")
                                      .arg(QDir::toNativeSeparators(*keptAs)));
            if (self)
                self->tell(keptAs.error().describe(), "error");
            else
                bench->messages().report(keptAs.error().describe());
        });
}

} // namespace gripscope
