// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/plant/plant_history.h"

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
        for (const auto& [library, version] : meeting.seen) {
            std::vector<Seen>& seen = m_seen[meeting.library][library];
            if (seen.empty() || seen.back().version < version)
                seen.push_back({meeting.version, version});
        }
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
    const auto seen = ofLibrary->second.find(earlier.library);
    if (seen == ofLibrary->second.end())
        return false;
    const auto after = std::ranges::upper_bound(seen->second, later.version, {}, &Seen::from);
    return after != seen->second.begin() && earlier.version <= std::prev(after)->version;
}

bool Causality::wereApart(const ChangeStamp& one, const ChangeStamp& other) const
{
    return !hasSeen(one, other) && !hasSeen(other, one);
}

} // namespace gripscope
