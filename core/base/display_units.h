// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>

namespace gripscope {

// Exact, by definition.
inline constexpr double newtonsPerPoundForce = 4.4482216152605;
inline constexpr double newtonsPerKilogramForce = 9.80665;
inline constexpr double metresPerInch = 0.0254;

/// What a number with a unit measures; the first three are the parameters, in their order.
enum class MechanicalQuantity { Mass, Damping, Stiffness, Force, Length };

/// The units in which a person reads and types forces, lengths, and the m, b and k that follow from them.
/// This is the one place that decides it. What is computed, stored, exported or sent is in SI or in the
/// channels' own units, whatever is chosen here.
struct DisplayUnits {
    enum class Force { Newton, PoundForce, KilogramForce };
    enum class Length { Metre, Inch };
    Force force = Force::Newton;
    Length length = Length::Metre;

    /// Of the whole program, as its language is. From any thread.
    [[nodiscard]] static DisplayUnits current();
    static void choose(DisplayUnits units);
    friend bool operator==(const DisplayUnits&, const DisplayUnits&) = default;
};

/// What a person may choose, the usual one first. It is kept under its name, which is what is read, too.
template <typename Unit>
struct UnitChoice {
    const char* name;
    Unit unit;
};
inline constexpr std::array<UnitChoice<DisplayUnits::Force>, 3> forceUnitChoices{
    {{"N", DisplayUnits::Force::Newton},
     {"lbf", DisplayUnits::Force::PoundForce},
     {"kgf", DisplayUnits::Force::KilogramForce}}};
inline constexpr std::array<UnitChoice<DisplayUnits::Length>, 2> lengthUnitChoices{
    {{"mm", DisplayUnits::Length::Metre}, {"in", DisplayUnits::Length::Inch}}};

/// A unit to show numbers in: shown number = number * factor.
struct ShownUnit {
    QString unit;
    double factor = 1;
};

/// For N, m, kg, N s/m, N/m and N/m³: what is read in its place, without a prefix. Other units, and those
/// that were chosen already, stay as they are.
[[nodiscard]] ShownUnit displayUnit(const QString& siUnit, DisplayUnits units = DisplayUnits::current());

/// For what stands still while its numbers change, and for what is typed: one handy multiple of the SI unit
/// (g, N s/m, kN/m, N, mm), or the unit chosen in its place.
[[nodiscard]] ShownUnit fieldUnit(MechanicalQuantity quantity, DisplayUnits units = DisplayUnits::current());

/// A value in SI with its unit, for sentences: forces and lengths with up to four digits ("12.5 N"), m, b
/// and k with three and an SI prefix ("39.6 g", "9.99 kN/m"). With a decimal point.
[[nodiscard]] QString quantityInWords(MechanicalQuantity quantity, double si, DisplayUnits units);

} // namespace gripscope
