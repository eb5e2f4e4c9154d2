// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QDateEdit;
class QLineEdit;
class QPushButton;

namespace gripscope {

/// Which squeezes the history shows: words, kind, outcome and type in one line, the rest in a second one that
/// can be folded away.
class HistoryFilterBar : public QWidget {
    Q_OBJECT
public:
    explicit HistoryFilterBar(QWidget* parent = nullptr);

    /// What narrows the query; its order is not the bar's.
    [[nodiscard]] HistoryQuery query() const;
    /// What there is to choose from now; what was chosen stays chosen.
    void setChoices(const HistoryChoices& choices);
    void clear();

signals:
    void changed();

private:
    [[nodiscard]] QWidget* buildFirst();
    [[nodiscard]] QWidget* buildSecond();
    [[nodiscard]] QComboBox* makeBox(const QString& all, const QString& name, const char* objectName);
    void showPeriod();
    void refreshMore();

    QLineEdit* m_text;
    QComboBox *m_kind, *m_outcome, *m_type, *m_expected, *m_operator, *m_device, *m_batch, *m_period;
    QDateEdit *m_from, *m_to;
    QPushButton *m_more, *m_clear;
    QWidget* m_second;
    QTimer m_typing; ///< words are applied once a person stops typing
};

} // namespace gripscope
