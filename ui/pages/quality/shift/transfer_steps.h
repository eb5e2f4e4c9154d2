// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/records/gripper_adjustment.h"
#include "core/session/quality/study_session.h"
#include "core/session/shift/transfer_look.h"

#include <QMap>
#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTableWidget;
class QVBoxLayout;

namespace gripscope {

class ElidedLabel;
class IntervalPlot;
class ProgressRing;
class TransferWatch;
class Workbench;

/// How things stand: which gripper is connected, where the types are from, which adjustments are in force;
/// and the choice of types that are squeezed on this one.
class TransferStart : public QWidget {
    Q_OBJECT
public:
    explicit TransferStart(Workbench& workbench, QWidget* parent = nullptr);
    void load();    ///< asks the library
    void refresh(); ///< what is connected
    [[nodiscard]] StudyRequest request() const;
    void focusFirst();

signals:
    void left();
    void submitted(const gripscope::StudyRequest& request);

private:
    struct Standing {
        QMap<QString, QStringList> grippers; ///< by type
        std::vector<AdjustmentRecord> adjustments;
        std::vector<AdjustmentStanding> inForce;
        qint64 studies = 0; ///< of this kind so far
    };
    [[nodiscard]] static Expected<Standing> read(Library& library);
    [[nodiscard]] QWidget* makeChoice(QWidget* parent);
    void fillTypes();
    void fillAdjustments();
    [[nodiscard]] QWidget* makeAdjustment(const AdjustmentRecord& record, QWidget* parent);
    void askWithdraw(const AdjustmentRecord& record);
    [[nodiscard]] QStringList chosen() const;
    [[nodiscard]] QString situation() const;
    [[nodiscard]] QString problem() const;

    Workbench* m_workbench;
    Standing m_standing;
    QLabel *m_situation, *m_hint;
    QSpinBox* m_trials;
    QPushButton* m_begin;
    QVBoxLayout *m_types, *m_adjustments;
    QWidget *m_typeBox, *m_adjustmentCard;
    std::vector<QCheckBox*> m_boxes;
    QString m_shownSerial; ///< the gripper that the list of types is for
};

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
