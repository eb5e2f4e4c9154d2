// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/gripper_adjustment.h"
#include "core/session/quality/study_session.h"

#include <QMap>
#include <QWidget>

#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace gripscope {

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

} // namespace gripscope
