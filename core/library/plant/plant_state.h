// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/plant/plant_conflict.h"

#include <QJsonObject>

namespace gripscope {

/// A type as all changes together leave it.
struct PlantType {
    QString typeId, name;
    TypeStatus status = TypeStatus::Enrolled;
    QString recipe; ///< its key
    QString code, limits;
    friend bool operator==(const PlantType&, const PlantType&) = default;
};

struct SqueezePlace {
    QString typeId;
    bool accepted = true;
    friend bool operator==(const SqueezePlace&, const SqueezePlace&) = default;
};

struct PlantState {
    std::map<QString, PlantType> types;       ///< by key; those that are gone, too
    std::map<QString, SqueezePlace> squeezes; ///< by key
    std::vector<PlantConflict> conflicts;     ///< by kind and type
};

/// The same for the same set of changes in any order.
[[nodiscard]] PlantState plantState(const PlantHistory& history);

/// The same text for the same state, to compare libraries by.
[[nodiscard]] QJsonObject canonicalJson(const PlantState& state);

} // namespace gripscope
