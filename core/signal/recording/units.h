// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <optional>

namespace gripscope {

/// Units of m, b and k that follow from those of the channels: N and mm give N s^2/mm, N s/mm, N/mm; N and m
/// give kg, N s/m, N/m; "1" and "1" give "1" three times (units as printed).
struct ParameterUnits {
    QString m, b, k;
    friend bool operator==(const ParameterUnits&, const ParameterUnits&) = default;
};
[[nodiscard]] ParameterUnits parameterUnits(const QString& forceUnit, const QString& positionUnit);
/// kg, N s/m, N/m.
[[nodiscard]] ParameterUnits siParameterUnits();
/// SI where siFactor() takes m, b and k there, else the units that follow from those of the channels.
[[nodiscard]] ParameterUnits comparableUnits(const QString& forceUnit, const QString& positionUnit);

/// The units of force and of position that are known, by every spelling.
[[nodiscard]] QStringList forceUnits();
[[nodiscard]] QStringList positionUnits();
/// Newtons in one `unit` of force (uN, mN, N, kN, gf, kgf, lbf), or nothing when the unit is not known.
[[nodiscard]] std::optional<double> newtonsPer(const QString& unit);
/// Metres in one `unit` of position (nm, um, µm, mm, cm, m, in), or nothing when the unit is not known.
[[nodiscard]] std::optional<double> metresPer(const QString& unit);

/// The factor that takes m, b and k (all three alike: force over position) from the channels' units to SI, or
/// nothing when a unit is not known.
[[nodiscard]] std::optional<double> siFactor(const QString& forceUnit, const QString& positionUnit);

/// The same for a cubic spring's k3, force over position cubed: N/m³ where the units are known.
[[nodiscard]] std::optional<double> cubicSiFactor(const QString& forceUnit, const QString& positionUnit);
[[nodiscard]] QString cubicStiffnessUnit(const QString& forceUnit, const QString& positionUnit);

} // namespace gripscope
