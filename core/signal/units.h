// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace gripscope {

/// Units of m, b and k that follow from those of the channels: N and mm give N s^2/mm, N s/mm, N/mm; N and m
/// give kg, N s/m, N/m; "1" and "1" give "1" three times (units as printed).
struct ParameterUnits {
    QString m, b, k;
    friend bool operator==(const ParameterUnits&, const ParameterUnits&) = default;
};
[[nodiscard]] ParameterUnits parameterUnits(const QString& forceUnit, const QString& positionUnit);

/// Newtons in one `unit` of force (uN, mN, N, kN), or nothing when the unit is not known.
[[nodiscard]] std::optional<double> newtonsPer(const QString& unit);
/// Metres in one `unit` of position (nm, um, µm, mm, cm, m), or nothing when the unit is not known.
[[nodiscard]] std::optional<double> metresPer(const QString& unit);

/// The factor that takes m, b and k (all three alike: force over position) from the channels' units to SI, or
/// nothing when a unit is not known.
[[nodiscard]] std::optional<double> siFactor(const QString& forceUnit, const QString& positionUnit);

} // namespace gripscope
