// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

namespace gripscope {

/// A moment that a person marked while it was measured.
struct RecordingMarker {
    double time_s = 0; ///< as in Recording::time_s
    QString words;     ///< may be empty
};

/// Notes those markers in the recording's provenance that lie between its first sample and its last, in order
/// of time: `marker_001: 12.5035 s: words`. What was noted before goes.
void noteMarkers(Recording& recording, std::vector<RecordingMarker> markers);

} // namespace gripscope
