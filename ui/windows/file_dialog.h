// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>

namespace gripscope {

/// Qt's own chooser of files, not the desktop's: that one would be a window without STOP, and modal. Goes
/// when it is closed.
class FileDialog : public QFileDialog {
    Q_OBJECT
public:
    explicit FileDialog(QWidget* parent, const QString& title, const QString& folder = {},
                        const QString& filter = {});
    void open() override; ///< as Dialog::open()
    using QFileDialog::open;
};

} // namespace gripscope
