// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"
#include "ui/stepped_work.h"

#include <QFrame>

class QLabel;
class QProgressBar;
class QPushButton;

namespace gripscope {

/// What the history is writing: how far it is, and Cancel. Hidden while nothing is written.
class HistoryWork : public QFrame {
    Q_OBJECT
public:
    explicit HistoryWork(Workbench& workbench, QWidget* parent = nullptr);

    /// One at a time; `doing`: "Writing history.csv"; `done` is told when all of it was.
    void run(SteppedWork::Step step, const QString& doing, const QString& done);
    /// The report, which is read on the library's thread and drawn in the pool.
    void writeReport(const HistoryQuery& query, const QString& file);
    [[nodiscard]] bool busy() const { return m_busy; }

signals:
    void busyChanged();

private:
    void begin(const QString& doing);
    void end();

    Workbench* m_workbench;
    QLabel* m_text;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    bool m_busy = false;
};

} // namespace gripscope
