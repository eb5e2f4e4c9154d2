// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/exchange/delivery.h"
#include "core/library/exchange/server_types.h"
#include "core/library/plant/plant_conflict.h"

#include <optional>
#include <vector>

namespace gripscope {

/// One step of keeping a station's library and its plant's server in step.
struct ExchangeStep {
    Delivery delivered;
    std::optional<DeliveredLinks> there; ///< where that is not as in the step before
    FetchedTypes fetched;
    QString marks; ///< marksOf() the server as far as it was read; for the next step
    std::optional<std::vector<PlantConflict>>
        conflicts;       ///< that nobody has seen; where they may have changed
    bool inStep = false; ///< nothing waits, and all types are here
};

/// Links that go in one write transaction of the server: some hundred rows, a fraction of a second in which
/// the other stations wait.
inline constexpr qint64 linksOfStep = 200;

} // namespace gripscope
