// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/windows/dialog.h"

class QLineEdit;
class QPushButton;

namespace gripscope {

/// Asks why an inspection does not count: the two reasons that there are every day by a press each, any other
/// in words.
class VoidDialog : public Dialog {
    Q_OBJECT
public:
    VoidDialog(qint64 number, QWidget* parent);

signals:
    void answered(const QString& reason); ///< accepted with this

private:
    void give(const QString& reason);
    QLineEdit* m_reason;
    QPushButton* m_accept;
};

} // namespace gripscope
