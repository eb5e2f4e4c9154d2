// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/settings/values/settings.h"

#include <QByteArray>

namespace gripscope {

/// All portable settings as a JSON document:
///   {"format": "gripscope-settings", "version": 1, "settings": {KEY: VALUE, ...}}
[[nodiscard]] QByteArray exportedSettings(const Settings& settings);

struct SettingChange {
    QString key;
    QVariant before, after;
};

/// What a document would do, worked out wholly before anything is done.
struct SettingsImport {
    std::vector<SettingChange> changes; ///< those that differ from what is in force
    QStringList errors; ///< a sentence for each value that cannot be used; with one, nothing is
    QStringList notes;  ///< a sentence for each key that is passed over
};

/// BadInput where it is no document of this format and version.
[[nodiscard]] Expected<SettingsImport> readSettings(const QByteArray& document, const QString& file,
                                                    const Settings& settings);
/// Nothing is changed where the import has errors.
void applyImport(Settings& settings, const SettingsImport& import);

} // namespace gripscope
