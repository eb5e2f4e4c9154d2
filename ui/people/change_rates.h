// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/stored_rates.h"

class QWidget;

namespace gripscope {

class Workbench;

/// What verdicts are held to from now on: where roles are in force by a supervisor, and always told to the
/// audit trail with the rates before.
void changeRates(Workbench& bench, QWidget* parent, const StoredRates& rates);

} // namespace gripscope
