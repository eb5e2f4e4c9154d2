// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QStringList>

class QLabel;
class QPushButton;

namespace gripscope {

/// What went wrong, and what was done, under the header until a person has read it: the newest message first,
/// the others behind it. Only what went wrong has the warning sign.
class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);

    void show(const QString& message);
    void tell(const QString& message); ///< of success
    [[nodiscard]] bool isGood(const QString& message) const { return m_good.contains(message); }
    void dismiss();                        ///< the one shown; the next takes its place
    void withdraw(const QString& message); ///< it holds no longer; read or not
    [[nodiscard]] QString message() const;
    [[nodiscard]] const QStringList& messages() const { return m_messages; } ///< newest first

signals:
    void changed(); ///< what is shown, and so its height

private:
    void refresh();
    void put(const QString& message);
    QWidget* m_sign;
    QStringList m_good; ///< those of m_messages that tell of success
    QLabel* m_text;
    QLabel* m_more;
    QPushButton* m_dismiss;
    QStringList m_messages; ///< newest first
};

} // namespace gripscope
