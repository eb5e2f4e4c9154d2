// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/windows/dialog.h"

class QLabel;
class QLineEdit;

namespace gripscope {

/// Asks for the address of a library on a PostgreSQL server. Says at once what cannot be one; whether there
/// is such a server is found out by whoever opens it.
class ServerDialog : public Dialog {
    Q_OBJECT
public:
    explicit ServerDialog(const QString& address, QWidget* parent = nullptr);
    [[nodiscard]] QString address() const; ///< as it is kept; empty while it cannot be one

private:
    QLineEdit* m_address;
    QLabel* m_problem;
};

} // namespace gripscope
