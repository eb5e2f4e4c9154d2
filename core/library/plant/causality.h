// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/plant/plant_history.h"

namespace gripscope {

/// What changes knew of each other, by the meetings of their libraries.
class Causality {
public:
    explicit Causality(std::vector<PlantMeeting> meetings);
    /// Whoever made `later` had `earlier` before their eyes: the same library had it, or had met it. Changes
    /// of before there were versions were seen by all.
    [[nodiscard]] bool hasSeen(const ChangeStamp& later, const ChangeStamp& earlier) const;
    /// Neither had seen the other.
    [[nodiscard]] bool wereApart(const ChangeStamp& one, const ChangeStamp& other) const;

private:
    /// From a version of a library on: the version of another up to which it has seen it.
    struct Seen {
        qint64 from = 0, version = 0;
    };
    /// By a library and one that it has seen, both numbers rising.
    std::map<QString, std::map<QString, std::vector<Seen>>> m_seen;
};

} // namespace gripscope
