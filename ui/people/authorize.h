// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/permission.h"

#include <QJsonObject>

#include <functional>

class QWidget;

namespace gripscope {

class Workbench;

/// Does `then` at once where the one who works here may do it; else asks for a supervisor and does it with
/// their consent, which is for this one time. Nothing is done when they cancel, or when `parent` is gone.
void authorize(Workbench& bench, QWidget* parent, Permission permission, std::function<void()> then);

/// The same for what is not kept in the library: the audit trail is told of it (`action`, see audit_action),
/// and only then it is done. `details`: the old and the new.
void authorizeRecorded(Workbench& bench, QWidget* parent, Permission permission, const QString& action,
                       const QString& subject, const QJsonObject& details, std::function<void()> then);

} // namespace gripscope
