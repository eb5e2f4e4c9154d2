// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <optional>

namespace gripscope::protocol {

/// The fields of which devices/PROTOCOL.md states a range.
enum class Field : std::uint8_t {
    ExcitationState,
    SampleCount,
    Result,
    ArmKey,
    ForceCount,
    ForceUnit,
    PositionUnit,
    ForceBetweenSamples,
    TakesCommands,
    Watchdog,
    ForcePerCount,
    PositionPerCount,
    SampleTime,
    Lag,
    LargestForce,
    LongestTravel,
    LongestExcitation,
};

/// A field whose number is outside least to most; all three in the field's unit.
struct FieldProblem {
    Field field{};
    double value = 0;
    double least = 0, most = 0;
    friend bool operator==(const FieldProblem&, const FieldProblem&) = default;
};

/// Nothing where `value` is from `least` to `most`, both included; a number that is not finite never is.
[[nodiscard]] std::optional<FieldProblem> outside(Field field, double value, double least, double most);

/// The field's name in devices/PROTOCOL.md, translated: "sample time".
[[nodiscard]] QString fieldName(Field field);
/// "sample time is 10 s; it must be from 1e-06 s to 1 s"
[[nodiscard]] QString describe(const FieldProblem& problem);

} // namespace gripscope::protocol
