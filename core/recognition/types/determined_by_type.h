// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/squeeze_values.h"

#include <QMap>
#include <QStringList>

#include <map>
#include <vector>

namespace gripscope {

/// What the squeezes of each type determine: many squeezes, few kinds of them. A type determines what more
/// than half of its squeezes do, so that one poor squeeze takes no quantity from all. Squeezes without any
/// usable quantity do not count.
class DeterminedByType {
public:
    explicit DeterminedByType(const std::vector<TypeSqueeze>& squeezes = {});

    /// The largest space that each type determines; of equally large ones that which comes first in order of
    /// TypeQuantity. m, b, k where there is no type; empty where they have nothing in common.
    [[nodiscard]] QuantitySpace space() const { return space(m_kinds.keys()); }
    /// The same of these alone; of those that are none nothing is asked.
    [[nodiscard]] QuantitySpace space(const QStringList& types) const;
    /// The types that determine all of the space, sorted.
    [[nodiscard]] QStringList typesWith(const QuantitySpace& space) const;
    /// Of each type by itself, each space once.
    [[nodiscard]] std::vector<QuantitySpace> ownSpaces() const;

private:
    using Kinds = std::map<Determines, int>; ///< how many squeezes determine what
    [[nodiscard]] static bool mostDetermine(const Kinds& kinds, QuantitySet set);
    QMap<QString, Kinds> m_kinds;
};

} // namespace gripscope
