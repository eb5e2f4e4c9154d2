// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/settings/values/setting.h"

namespace gripscope {

// Rows of the table of settings; names and explanations are to be translated.
[[nodiscard]] inline Setting switchSetting(const char* key, bool fallback, SettingGroup group,
                                           const char* name, const char* explanation)
{
    return {key, SettingKind::Switch, fallback, group, name, explanation};
}

[[nodiscard]] inline Setting choiceSetting(const char* key, const char* fallback, SettingGroup group,
                                           const char* name, const char* explanation,
                                           std::vector<SettingChoice> choices)
{
    Setting made{key, SettingKind::Choice, QString::fromLatin1(fallback), group, name, explanation};
    made.choices = std::move(choices);
    return made;
}

[[nodiscard]] inline Setting textSetting(const char* key, SettingKind kind, SettingGroup group,
                                         const char* name, const char* explanation)
{
    return {key, kind, QString(), group, name, explanation};
}

/// A PLC that triggers (the manual's page plant).
[[nodiscard]] std::vector<Setting> lineSettings();
/// Results over MQTT.
[[nodiscard]] std::vector<Setting> brokerSettings();
/// A plant's library on a server.
[[nodiscard]] std::vector<Setting> plantSettings();

} // namespace gripscope
