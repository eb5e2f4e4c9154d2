// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/permission.h"
#include "ui/settings/values/settings_exchange.h"
#include "ui/settings/values/stored_rates.h"

#include <QJsonObject>

#include <functional>

class QWidget;

namespace gripscope {

class Workbench;

/// From now on the questions of `bench`, who somebody is and whether a supervisor agrees, are asked by
/// dialogs, as long as `window` is there.
void answerForPeople(Workbench& bench, QObject* window);

/// Does `then` at once where the one who works here may do it; else asks for a supervisor and does it with
/// their consent, which is for this one time. Nothing is done when they cancel, or when `parent` is gone.
void authorize(Workbench& bench, QWidget* parent, Permission permission, std::function<void()> then);

/// Asks why before what verdicts depend on is changed, whether or not roles are in force. `then` gets the
/// reason, which is never empty; nothing is done when none is given, or when `parent` is gone. `change`: what
/// is to be done, as a heading.
void askWhy(QWidget* parent, const QString& change, std::function<void(const QString& reason)> then);

/// As authorize() for what is not kept in the library: the audit trail is told of it (`action`, see
/// audit_action), and only then it is done. `details`: the old and the new.
void authorizeRecorded(Workbench& bench, QWidget* parent, Permission permission, const QString& action,
                       const QString& subject, const QJsonObject& details, std::function<void()> then,
                       const QString& reason = {});

/// Does `apply`, which makes these changes: at once where none of them needs a supervisor, else with one's
/// consent where roles are in force, and told to the audit trail. Where one of them needs a reason, that is
/// asked for first.
void changeSettings(Workbench& bench, QWidget* parent, const std::vector<SettingChange>& changes,
                    std::function<void()> apply);
/// What resetAll() would change.
[[nodiscard]] std::vector<SettingChange> changesOfReset(const Settings& settings);

/// What verdicts are held to from now on: where roles are in force by a supervisor, and always told to the
/// audit trail with the rates before and the reason, which is asked for.
void changeRates(Workbench& bench, QWidget* parent, const StoredRates& rates);

} // namespace gripscope
