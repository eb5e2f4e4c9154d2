// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/batch.h"

#include <QDialog>

class QLineEdit;
class QPushButton;
class QSpinBox;

namespace gripscope {

/// Asks for the name and size of the next batch, and says what counts towards it.
class BatchDialog : public QDialog {
    Q_OBJECT
public:
    /// `expectedType`: what its parts are expected to be; empty: nothing.
    explicit BatchDialog(const QString& expectedType, QWidget* parent = nullptr);
    [[nodiscard]] NewBatch batch() const;

private:
    void refresh();
    QString m_expectedType;
    QLineEdit* m_name;
    QSpinBox* m_target;
    QPushButton* m_accept;
};

} // namespace gripscope
