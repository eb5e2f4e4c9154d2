// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_advice.h"
#include "core/work_watch.h"

#include <QTimer>
#include <QWidget>

#include <memory>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace gripscope {

class AdviceTableModel;

/// How many clusters there seem to be: on request the criteria side by side, and the choice in a sentence.
class AdvicePanel : public QWidget {
    Q_OBJECT
public:
    explicit AdvicePanel(QWidget* parent = nullptr);

    /// Shows how far the work is until an answer, a failure or clear() comes.
    void setRunning(const std::shared_ptr<WorkWatch>& watch);
    void setAdvice(const ClusterAdvice& advice);
    void setFailure(const QString& words);
    void clear(); ///< back to the offer
    [[nodiscard]] bool running() const { return m_watch != nullptr; }
    [[nodiscard]] bool showsAdvice() const;

signals:
    void asked();
    void cancelled();
    void chosen(int clusters); ///< the advised number is to be used

private:
    void refresh();

    std::shared_ptr<WorkWatch> m_watch;
    QTimer m_poll;
    int m_advised = 1;
    AdviceTableModel* m_model;
    QPushButton* m_ask;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    QLabel* m_reason;
    QTableView* m_table;
    QPushButton* m_use;
};

} // namespace gripscope
