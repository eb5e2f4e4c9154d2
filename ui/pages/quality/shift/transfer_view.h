// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_session.h"
#include "core/session/shift/transfer_watch.h"

#include <QWidget>

class QStackedWidget;

namespace gripscope {

class TransferLead;
class TransferOutcome;
class TransferStart;
class Workbench;

/// Types on another gripper: the choice of types, the squeezes, the adjustment; shown is what the study
/// session has, and the choice where it has no transfer.
class TransferView : public QWidget {
    Q_OBJECT
public:
    explicit TransferView(Workbench& workbench, QWidget* parent = nullptr);
    void begin();   ///< the choice, anew
    void refresh(); ///< the session, or the connection, has changed
    void focusFirst();
    void act(); ///< Space
    void undo();
    [[nodiscard]] const TransferWatch& watch() const { return m_watch; }

signals:
    void left();
    void submitted(const gripscope::StudyRequest& request);

private:
    void poll();
    void showStep();

    Workbench* m_workbench;
    TransferWatch m_watch;
    QStackedWidget* m_stack;
    TransferStart* m_start;
    TransferLead* m_lead;
    TransferOutcome* m_outcome;
    QString m_ended; ///< the study whose outcome is shown
};

} // namespace gripscope
