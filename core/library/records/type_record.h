// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/library_change.h"
#include "core/quality/conformity/part_limits.h"
#include "core/signal/excitation/excitation.h"

#include <QDateTime>
#include <QString>

#include <vector>

namespace gripscope {

/// How a part is squeezed. Forces in newtons.
struct Recipe {
    QString name = QStringLiteral("squeeze-10N");
    double peak_N = 10, bias_N = 20, bit_s = 0.005, seconds = 1.0;
    double maxForce_N = 40; ///< crush limit: no command for this type goes above
    double maxTravel_m = 0.02;
    ExcitationKind kind = ExcitationKind::Prbs; ///< how the force goes about the preload, within +-peak
    std::vector<double> levels = {};            ///< of ExcitationKind::Levels, see ExcitationOptions
    friend bool operator==(const Recipe&, const Recipe&) = default;
};

/// The one of a new type until somebody chooses another: it also sees friction, which hides in the stiffness
/// where the force has two levels.
[[nodiscard]] inline Recipe recipeOfNewTypes()
{
    Recipe recipe;
    recipe.kind = ExcitationKind::FourLevel;
    return recipe;
}

struct TypeRecord {
    QString id, name;
    Recipe recipe;
    QString forceUnit, positionUnit; ///< units of its squeezes' estimates
    QDateTime created;
    int squeezes = 0; ///< accepted ones
    bool approved = false;
    TypeStatus status = TypeStatus::Enrolled;
    int recipeVersion = 1;  ///< its recipes are numbered from 1
    QString code = {};      ///< what a scanner reads on its parts (a GTIN...); empty: none
    PartLimits limits = {}; ///< what its parts may be; empty: none
    int place = 0; ///< among all types there ever were, by when they came: its sign and colour, for life
};

} // namespace gripscope
