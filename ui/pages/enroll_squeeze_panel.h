// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/enroll_advisor.h"
#include "ui/pages/enroll_squeeze_model.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace gripscope {

class PartPictureView;
class ProgressRing;
class Workbench;

/// The squeeze step of an enrolment: a ring that fills, the last squeeze with accept and reject, and all of
/// them; with words on whether they are enough, and which of them does not go with the others.
class EnrollSqueezePanel : public QWidget {
    Q_OBJECT
public:
    explicit EnrollSqueezePanel(Workbench& workbench, QWidget* parent = nullptr);
    void refresh();
    void focusNext(); ///< on what is to be done next
    /// What Space does here: squeeze when one is due, accept when one waits for it.
    void squeezeOrAccept();
    /// Valid squeezes that go with the others are accepted without asking; on at first.
    void setAcceptsByItself(bool on);
    /// The squeeze that waits, or will, is a person's to decide on.
    void leaveToPerson() { m_ownSqueeze = -1; }

signals:
    void changed();

private:
    QWidget* makeSide();
    QWidget* makeLast(QWidget* parent);
    QWidget* makePart(QWidget* parent);
    QWidget* makeTable();
    void squeeze();
    void accept();
    void reject();
    void askDrop();
    void review();
    void tell(const Expected<void>& done);
    void refreshLast();
    bool showLive();
    void acceptByItself();
    [[nodiscard]] bool decidesByItself() const;
    void refreshAdvice();
    [[nodiscard]] int rowToDrop() const; ///< the selected one, else an accepted outlier; -1: none
    [[nodiscard]] QString outlierReason(int row) const;
    Workbench* m_workbench;
    EnrollAdvisor m_advisor;
    EnrollSqueezeModel m_model;
    QLabel *m_title, *m_advice, *m_hint, *m_lastTitle, *m_lastNumbers, *m_lastWords;
    ProgressRing* m_ring;
    PartPictureView* m_picture;
    QLineEdit* m_part;
    QCheckBox* m_itself;
    QPushButton *m_squeeze, *m_arm, *m_accept, *m_reject, *m_drop, *m_review;
    QTableView* m_table;
    bool m_ready = false;
    int m_ownSqueeze = -1; ///< row of the squeeze that may be accepted by itself; -1: none
    EnrollSession::Activity m_shown = EnrollSession::Activity::Waiting;
};

} // namespace gripscope
