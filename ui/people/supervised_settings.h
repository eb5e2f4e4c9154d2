// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/settings/settings_exchange.h"

#include <functional>

class QWidget;

namespace gripscope {

class Workbench;

/// Does `apply`, which makes these changes: at once where none of them needs a supervisor, else with one's
/// consent where roles are in force, and told to the audit trail.
void changeSettings(Workbench& bench, QWidget* parent, const std::vector<SettingChange>& changes,
                    std::function<void()> apply);
/// What resetAll() would change.
[[nodiscard]] std::vector<SettingChange> changesOfReset(const Settings& settings);

} // namespace gripscope
