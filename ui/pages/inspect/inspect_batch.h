// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/batch.h"
#include "ui/windows/dialog.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace gripscope {

class ElidedLabel;
class FittedLabel;
class Workbench;

/// Asks for the name and size of the next batch, and says what counts towards it.
class BatchDialog : public Dialog {
    Q_OBJECT
public:
    /// `expectedType`: what its parts are expected to be; empty: nothing.
    explicit BatchDialog(const QString& expectedType, QWidget* parent = nullptr);
    [[nodiscard]] NewBatch batch() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void refresh();
    void takeEnter();
    QString m_expectedType;
    QElapsedTimer m_sinceName; ///< since Enter ended the name
    QLineEdit* m_name;
    QSpinBox* m_target;
    QPushButton* m_accept;
};

/// The batch of the Inspect page: how far it is, and where it is begun and ended.
class InspectBatch : public QWidget {
    Q_OBJECT
public:
    explicit InspectBatch(Workbench& workbench, QWidget* parent = nullptr);
    void setExpected(const QString& type) { m_expected = type; } ///< of the next batch
    void setCountHeight(int pixels);                             ///< of how far it is, read from afar

signals:
    void whole(); ///< the last part that was wanted has just been counted
    /// The batch that is under way expects this; told when it begins, and when it goes on after a start.
    void expects(const QString& type);

private:
    void refresh();
    void show(const BatchRecord& batch);
    void notice(const std::optional<BatchRecord>& batch);
    void askToBegin();
    void askToEnd();
    Workbench* m_workbench;
    QWidget* m_progress;
    ElidedLabel* m_name;
    FittedLabel* m_count;
    QLabel* m_yield;
    QProgressBar* m_bar;
    QPushButton *m_begin, *m_end;
    QString m_expected;
    QString m_known; ///< key of the batch that was told of
    bool m_ended = false;
};

} // namespace gripscope
