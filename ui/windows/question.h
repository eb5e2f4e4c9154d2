// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/windows/dialog.h"

class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace gripscope {

/// Asks whether to go on: a heading, what follows from it, and two buttons. Goes when it is answered.
class Question : public Dialog {
    Q_OBJECT
public:
    /// `yes` accepts, `no` rejects and has the focus: Enter changes nothing.
    Question(const QString& title, const QString& words, const QString& yes, const QString& no,
             QWidget* parent);
    [[nodiscard]] QPushButton* yes() const { return m_yes; }
    [[nodiscard]] QPushButton* no() const { return m_no; }

private:
    QPushButton *m_yes, *m_no;
};

/// Asks for a line of text. Goes when it is answered.
class TextQuestion : public Dialog {
    Q_OBJECT
public:
    TextQuestion(const QString& title, const QString& words, const QString& initial, const QString& accept,
                 QWidget* parent);
    [[nodiscard]] QString text() const;
    [[nodiscard]] QLineEdit* field() const { return m_field; }
    /// Only blanks are no answer.
    void requireText();

signals:
    void answered(const QString& text); ///< accepted with this

private:
    QLineEdit* m_field;
    QPushButton* m_accept;
};

} // namespace gripscope
