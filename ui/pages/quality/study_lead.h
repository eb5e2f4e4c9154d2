// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gripscope {

class ElidedLabel;
class ProgressRing;
class Workbench;

/// Leads through a study: who puts in which part, its squeeze or verdict, how far it is. Of what was measured
/// nothing is seen. A part may be told by its label or a scanner before its squeeze: another one than is
/// asked for is refused. Enter in that field never squeezes.
class StudyLead : public QWidget {
    Q_OBJECT
public:
    explicit StudyLead(Workbench& workbench, QWidget* parent = nullptr);
    void refresh();
    void focusNext(); ///< where Space or the scanner is to go
    void act();       ///< Space: squeezes, or finishes when all is through
    void undo();

signals:
    void paused();

private:
    [[nodiscard]] QWidget* makeTask();
    [[nodiscard]] QWidget* makePart(QWidget* parent);
    [[nodiscard]] QWidget* makeRating(QWidget* parent);
    [[nodiscard]] QWidget* makeSide();
    void refreshTask();
    void refreshButtons();
    void refreshLast();
    [[nodiscard]] QString hint() const;
    [[nodiscard]] bool rated() const; ///< people judge; nothing is squeezed
    [[nodiscard]] bool through() const;
    [[nodiscard]] bool mayGoOn() const; ///< the right part is known to be in
    void takeLabel();
    void squeeze();
    void rate(const QString& word);
    void fillRatings();
    void askSkip();
    void askEnd();
    void tell(const Expected<void>& done);

    Workbench* m_workbench;
    QLabel *m_name, *m_who, *m_part, *m_trial, *m_hint, *m_words, *m_last, *m_wrongPart;
    ProgressRing* m_ring;
    QLineEdit *m_label, *m_word;
    QCheckBox* m_scanFirst;
    QWidget *m_labelBox, *m_ratingBox;
    QHBoxLayout* m_ratings;
    QPushButton *m_arm, *m_act, *m_undo, *m_skip, *m_pause, *m_end;
    std::optional<std::size_t> m_row;      ///< shown
    std::optional<std::size_t> m_labelled; ///< the row whose part was told
    bool m_wrong = false;                  ///< another part was told
    int m_shown = -1;                      ///< state of the session, and whether it is ready
};

} // namespace gripscope
