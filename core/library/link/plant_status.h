// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/plant/plant_conflict.h"

#include <QDateTime>

#include <optional>
#include <vector>

namespace gripscope {

/// How a station stands with its plant's server.
struct PlantStatus {
    bool on = false;
    QString server;        ///< its address, without a password
    bool reached = false;  ///< it answers
    QDateTime lastReached; ///< UTC, by an earlier program too; invalid: never
    bool inStep = false;   ///< while it is reached: the server has all, and all that it has is here
    std::optional<qint64>
        waiting;                  ///< inspections that the server has not; unknown before it was ever reached
    std::optional<Error> problem; ///< why it is not reached, or why nothing is brought; until that is over
    std::vector<PlantConflict> conflicts; ///< that nobody has seen
    qint64 typesTaken =
        0; ///< how often types, calibrations or limits came from there, since this program runs
};

} // namespace gripscope
