// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QObject;

namespace gripscope {

class Workbench;

/// Fetches the recording of a stored squeeze, identifies it anew in the pool and brings it up on the Fit
/// page. Errors go to the message bar. Nothing happens once `context` is gone.
void openStoredSqueeze(Workbench& workbench, QObject* context, const QString& graspId, const QString& title);

} // namespace gripscope
