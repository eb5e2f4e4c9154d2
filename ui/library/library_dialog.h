// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/backup/library_restore.h"
#include "ui/windows/dialog.h"

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace gripscope {

class Workbench;

/// What a backup holds beside what the library holds now, what would be lost, and why it is put back.
/// Accepted only with a reason.
class RestoreDialog : public Dialog {
    Q_OBJECT
public:
    explicit RestoreDialog(const RestorePlan& plan, QWidget* parent = nullptr);
    [[nodiscard]] QString reason() const;

private:
    [[nodiscard]] QGridLayout* makeTable(const RestorePlan& plan);
    QLineEdit* m_reason;
};

/// Asks for the address of a library on a PostgreSQL server. Says at once what cannot be one; whether there
/// is such a server is found out by whoever opens it.
class ServerDialog : public Dialog {
    Q_OBJECT
public:
    explicit ServerDialog(const QString& address, QWidget* parent = nullptr);
    [[nodiscard]] QString address() const; ///< as it is kept; empty while it cannot be one

private:
    QLineEdit* m_address;
    QLabel* m_problem;
};

/// The library that is open: what is in it; another one in its place, a backup of it, and a backup put back.
/// Nothing here is done on the screen's thread, and what takes long can be cancelled.
class LibraryDialog : public Dialog {
    Q_OBJECT
public:
    explicit LibraryDialog(Workbench& workbench, QWidget* parent = nullptr);
    ~LibraryDialog() override;

    void openLibrary(const QString& place);
    void backUpTo(const QString& file);
    void restoreFrom(const QString& file);

private:
    struct Work;
    QHBoxLayout* makeActions();
    QHBoxLayout* makeFoot();
    void addRecent();
    void reload();
    void chooseToOpen();
    void chooseServer();
    [[nodiscard]] QString folderOfLibrary() const;
    [[nodiscard]] QList<QWidget*> actions() const;
    void chooseBackup();
    void chooseToRestore();
    [[nodiscard]] bool mayLeave(); ///< nothing is under way that belongs to the library; else says what
    void begin(const QString& words);
    void end();
    void showProgress();
    void tell(const QString& words, const char* role);
    void askToRestore(const RestorePlan& plan);
    void restore(const QString& reason);
    Workbench* m_workbench;
    QLabel *m_contents, *m_state;
    QListWidget* m_recent;
    QPushButton *m_open, *m_server, *m_backUp, *m_restore, *m_cancel;
    QProgressBar* m_progress;
    QTimer m_look;
    std::shared_ptr<Work> m_work;      ///< what is under way, shared with its thread
    std::optional<RestorePlan> m_plan; ///< prepared, and neither used nor discarded
};

} // namespace gripscope
