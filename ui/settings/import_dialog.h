// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/settings/settings_exchange.h"

#include <QDialog>

namespace gripscope {

/// What a file of settings would change, before it does: each setting as it is and as it would be, and what
/// is wrong with the file. Accepted only where nothing is.
class ImportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ImportDialog(const SettingsImport& import, QWidget* parent = nullptr);

private:
    [[nodiscard]] QWidget* makeTable(const SettingsImport& import);
};

} // namespace gripscope
