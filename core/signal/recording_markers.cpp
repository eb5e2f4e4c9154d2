// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording_markers.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

void noteMarkers(Recording& recording, std::vector<RecordingMarker> markers)
{
    const QString prefix = u"marker_"_qs;
    recording.provenance.removeIf([&](const auto& fact) { return fact.key().startsWith(prefix); });
    if (recording.time_s.empty())
        return;
    std::sort(markers.begin(), markers.end(),
              [](const RecordingMarker& a, const RecordingMarker& b) { return a.time_s < b.time_s; });
    int number = 0;
    for (const RecordingMarker& marker : markers) {
        if (marker.time_s < recording.time_s.front() || marker.time_s > recording.time_s.back())
            continue;
        const QString words = marker.words.simplified();
        const QString time = u"%1 s"_qs.arg(marker.time_s, 0, 'g', 12);
        recording.provenance[prefix + u"%1"_qs.arg(++number, 3, 10, QChar(u'0'))] =
            words.isEmpty() ? time : u"%1: %2"_qs.arg(time, words);
    }
}

} // namespace gripscope
