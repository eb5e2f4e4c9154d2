// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace gripscope {

/// What the program is, which version, and every key that does something.
class AboutDialog : public QDialog {
    Q_OBJECT
public:
    explicit AboutDialog(const QStringList& pageTitles, QWidget* parent = nullptr);
};

} // namespace gripscope
