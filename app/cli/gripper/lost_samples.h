// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"

namespace gripscope::cli {

/// Samples that are missing in a recording.
[[nodiscard]] inline qint64 lostSamples(const Recording& recording)
{
    qint64 lost = 0;
    for (const Gap& gap : findGaps(recording))
        lost += gap.lostSamples;
    return lost;
}

} // namespace gripscope::cli
