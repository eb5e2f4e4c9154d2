// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QMap>
#include <QString>

#include <cstdint>
#include <functional>

namespace gripscope::cli {

/// Counts of a demonstration, as they fell.
struct DemoCounts {
    int enrolled = 0;
    int tested = 0, correct = 0, wrongType = 0, unknown = 0;
    int strangers = 0, strangersUnknown = 0;
    QMap<QString, QMap<QString, int>> confusion; ///< true object -> what the verdict named -> how often
};

/// The whole chain on the virtual gripper, as fast as it can: 10 squeezes of each of the 4 cans enrolled, 30
/// unseen ones and 5 of a stranger inspected. Every squeeze is another one of its can, from a seed of its
/// own. The library is a temporary file. `progress` is told what is being done.
[[nodiscard]] Expected<DemoCounts> runDemonstration(std::uint64_t seed,
                                                    const std::function<void(const QString&)>& progress);

} // namespace gripscope::cli
