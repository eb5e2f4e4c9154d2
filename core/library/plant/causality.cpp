// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/plant/causality.h"

#include <algorithm>
#include <tuple>

namespace gripscope {

bool comesBefore(const ChangeStamp& one, const ChangeStamp& other)
{
    return std::tie(one.version, one.utc, one.station, one.row) <
           std::tie(other.version, other.utc, other.station, other.row);
}

Causality::Causality(std::vector<PlantMeeting> meetings)
{
    std::sort(meetings.begin(), meetings.end(), [](const PlantMeeting& one, const PlantMeeting& other) {
        return std::tie(one.library, one.version) < std::tie(other.library, other.version);
    });
    for (const PlantMeeting& meeting : meetings) {
        auto& ofLibrary = m_seen[meeting.library];
        std::map<QString, qint64> seen =
            ofLibrary.empty() ? std::map<QString, qint64>() : ofLibrary.rbegin()->second;
        for (const auto& [library, version] : meeting.seen)
            seen[library] = std::max(seen[library], version);
        ofLibrary[meeting.version] = std::move(seen);
    }
}

bool Causality::hasSeen(const ChangeStamp& later, const ChangeStamp& earlier) const
{
    if (earlier.version == 0)
        return true;
    if (later.library == earlier.library)
        return earlier.version <= later.version;
    const auto ofLibrary = m_seen.find(later.library);
    if (ofLibrary == m_seen.end())
        return false;
    const auto after = ofLibrary->second.upper_bound(later.version);
    if (after == ofLibrary->second.begin())
        return false;
    const auto& seen = std::prev(after)->second;
    const auto known = seen.find(earlier.library);
    return known != seen.end() && earlier.version <= known->second;
}

bool Causality::wereApart(const ChangeStamp& one, const ChangeStamp& other) const
{
    return !hasSeen(one, other) && !hasSeen(other, one);
}

} // namespace gripscope
