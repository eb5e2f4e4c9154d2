// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/base/error.h"

#include <QString>

#include <optional>

namespace gripscope {

/// What the loads of a calibration were said in: the quantity of the channel, or masses, whose weight is the
/// load.
enum class LoadUnit { Channel, Kilogram, Pound };
[[nodiscard]] QString toString(LoadUnit unit); ///< "", "kg", "lb"
[[nodiscard]] std::optional<LoadUnit> loadUnitFromString(const QString& text);

/// By agreement, m/s² (3rd CGPM, 1901). On the ground it is 9.764 to 9.834.
inline constexpr double standardGravity = 9.80665;
inline constexpr double leastGravity = 9.76, mostGravity = 9.84;

/// The unit of such masses, its number for one newton that they weigh. Nothing for LoadUnit::Channel.
[[nodiscard]] std::optional<ShownUnit> massPerNewton(LoadUnit unit, double gravity);

/// Their number for one `channelUnit` of force; nothing, too, where that unit is not known.
[[nodiscard]] std::optional<ShownUnit> massPerLoad(LoadUnit unit, double gravity, const QString& channelUnit);

/// How a statement of conformity allows for the uncertainty (JCGM 106:2012, ILAC-G8:09/2019).
enum class DecisionRule {
    Guarded, ///< conforms where error and expanded uncertainty together are within the tolerance
    Simple,  ///< conforms where the error alone is
};
[[nodiscard]] QString toString(DecisionRule rule); ///< "guarded", "simple"
[[nodiscard]] std::optional<DecisionRule> decisionRuleFromString(const QString& text);

/// What a certificate says beside points and curve.
struct CalibrationConditions {
    LoadUnit loadUnit = LoadUnit::Channel;
    double gravity = standardGravity; ///< local, m/s²: counts where the loads are masses
    std::optional<double> ambient_C;  ///< temperature beside the gripper
    std::optional<double> tolerance;  ///< largest error of a load, in the channel's unit
    DecisionRule rule = DecisionRule::Guarded;
    friend bool operator==(const CalibrationConditions&, const CalibrationConditions&) = default;
};

/// Where a calibration makes sense: from a cold store to a drying oven.
inline constexpr double leastAmbient_C = -20, mostAmbient_C = 60;

/// Why conditions cannot be so; nothing when they can.
[[nodiscard]] std::optional<Error> problemOf(const CalibrationConditions& conditions);

} // namespace gripscope
