// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/signal/recording/recording.h"

#include <QString>

class QObject;

namespace gripscope {

class Workbench;

/// Fetches the recording of a stored squeeze, identifies it anew in the pool and brings it up on the Fit
/// page, from where a person gets back to the page `backTo`. Errors go to the message bar. Nothing happens
/// once `context` is gone.
void openStoredSqueeze(Workbench& workbench, QObject* context, const QString& graspId, const QString& title,
                       const QString& backTo);

/// A simulated squeeze of an object in SI (2 kHz, one second, PRBS of 20 +- 10 N, position noise of 5 um),
/// for pages that have to show something before there is a gripper. Its provenance says that it is simulated.
[[nodiscard]] Recording simulatedSqueeze(const MassDampingStiffness& object, std::uint64_t seed);

} // namespace gripscope
