// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/plant/plant_history.h"

namespace gripscope {

/// What stations decided while apart, so that a supervisor is to look at it.
struct PlantConflict {
    enum class Kind {
        Name,   ///< one type, two names
        Status, ///< such as retired here, approved there
        Recipe,
        Code,
        Limits,
        SameName, ///< two types, one name
        SameCode, ///< two types, one code
        Approval, ///< squeezes or limits came that the approval had not seen
        GivenUp   ///< squeezes came to a type that was merged into another
    };
    /// What one station said.
    struct Side {
        ChangeStamp stamp;
        QString value; ///< as it is stored; for a recipe its key
        friend bool operator==(const Side&, const Side&) = default;
    };
    Kind kind = Kind::Name;
    QString typeId, type; ///< its name as it is in force
    Side inForce;
    std::vector<Side> onRecord; ///< the later first

    /// The same whoever computes it; another once somebody has decided again.
    [[nodiscard]] QString id() const;
    friend bool operator==(const PlantConflict&, const PlantConflict&) = default;
};
[[nodiscard]] QString toString(PlantConflict::Kind kind); ///< "name", "same_name"...

/// "Stations gave Cola another name while apart: 'Cola 330' by B. on hall-2 is in force; 'Cola small' by A.
/// on hall-1 is on record." What to do next follows it.
[[nodiscard]] QString inWords(const PlantConflict& conflict);

} // namespace gripscope
