// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/shift/transfer_look.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace gripscope {

class IntervalPlot;
class ProgressRing;
class TransferWatch;
class Workbench;

/// Leads through the squeezes of a transfer: a part of which type, the how-manieth, why, how many more it
/// takes, and what the squeezes so far say.
class TransferLead : public QWidget {
    Q_OBJECT
public:
    TransferLead(Workbench& workbench, const TransferWatch& watch, QWidget* parent = nullptr);
    void refresh();
    void focusNext();
    void act(); ///< Space: squeezes
    void undo();

signals:
    void paused();

private:
    [[nodiscard]] QWidget* makeTask();
    [[nodiscard]] QWidget* makeSide();
    void refreshTask();
    void refreshButtons();
    void refreshLook();
    [[nodiscard]] QString hint() const;
    void finish();
    void askSkip();
    void askGiveUp();
    void tell(const Expected<void>& done);

    Workbench* m_workbench;
    const TransferWatch* m_watch;
    QLabel *m_name, *m_part, *m_trial, *m_why, *m_hint, *m_last, *m_doubt, *m_advice, *m_words;
    ProgressRing* m_ring;
    IntervalPlot* m_plot;
    QPushButton *m_arm, *m_act, *m_finish, *m_undo, *m_skip, *m_pause, *m_giveUp;
    std::optional<std::size_t> m_row; ///< shown
    int m_shown = -1;                 ///< state of the session, and whether it is ready
};

} // namespace gripscope
