// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windows/file_dialog.h"

#include "ui/windows/dialog.h"

namespace gripscope {

namespace {
const RegisteredDialog<FileDialog> fileRow("file", [](Workbench&, QWidget* over) {
    return new FileDialog(over, QString());
});
} // namespace

FileDialog::FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter)
    : QFileDialog(parent ? parent->window() : nullptr, title, folder, filter)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setOption(QFileDialog::DontUseNativeDialog);
    setWindowModality(Qt::NonModal);
}

void FileDialog::open()
{
    setResult(0);
    show();
    raise();
    activateWindow();
}

} // namespace gripscope
