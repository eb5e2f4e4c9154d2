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
    /// Of a library, by its version from which on: what was seen of others.
    std::map<QString, std::map<qint64, std::map<QString, qint64>>> m_seen;
};

} // namespace gripscope
