// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/gripper_adjustment.h"
#include "core/session/shift/transfer_look.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableWidget;

namespace gripscope {

class ElidedLabel;
class IntervalPlot;
class TransferWatch;
class Workbench;

/// What a transfer comes to: by how much this gripper finds more or less, before and after, whether one
/// adjustment explains all types, and its acceptance by who may.
class TransferOutcome : public QWidget {
    Q_OBJECT
public:
    TransferOutcome(Workbench& workbench, const TransferWatch& watch, QWidget* parent = nullptr);
    void begin(); ///< of another study than before
    void refresh();
    void focusFirst();

signals:
    void left();     ///< back to the list
    void accepted(); ///< the adjustment is in force

private:
    [[nodiscard]] QWidget* makeHead();
    [[nodiscard]] QWidget* makeTable(QWidget* parent);
    void showLook(const TransferLook& look);
    void showTable(const TransferLook& look);
    void loadStanding();
    void askAccept();
    void accept(const QString& reason);
    [[nodiscard]] QString obstacle() const; ///< why it cannot be accepted; empty: it can

    Workbench* m_workbench;
    const TransferWatch* m_watch;
    ElidedLabel *m_name, *m_facts;
    QLabel *m_verdict, *m_words, *m_check, *m_standing;
    IntervalPlot* m_plot;
    QTableWidget* m_table;
    QWidget* m_figures;
    QPushButton* m_accept;
    std::optional<AdjustmentRecord> m_own;    ///< accepted of this study
    std::optional<AdjustmentRecord> m_before; ///< in force for this gripper
    bool m_isStandingKnown = false, m_isAsked = false;
};

} // namespace gripscope
