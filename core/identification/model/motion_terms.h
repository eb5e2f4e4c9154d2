// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// What a right-hand side can have. In the order in which they stand in documents, after m, b and k.
enum class MotionParameter {
    Mass,
    Damping,
    Stiffness,      ///< the relaxed one: what is left when one waits
    Friction,       ///< Coulomb's
    Relaxing,       ///< k1: the spring behind the dashpot; k + k1 is the instantaneous stiffness
    RelaxationTime, ///< tau of that dashpot
    Cubic,          ///< k3
    DampingBack,    ///< b of motion towards smaller positions, where each way has its own
    FrictionBack,   ///< Fc of such motion
    ForceOffset,    ///< of the force channel
};
inline constexpr std::size_t motionParameters = 10;

/// "m", "b", "k", "Fc", "k1", "tau", "k3", "b_back", "Fc_back", "force_offset".
[[nodiscard]] QString toString(MotionParameter parameter);
/// Above zero, and searched in its logarithm: m, b, k, k1, tau, b_back.
[[nodiscard]] bool isPositive(MotionParameter parameter);
/// Not below zero: Fc, Fc_back.
[[nodiscard]] bool isFriction(MotionParameter parameter);
/// 0, 1, 2 for m, b and k; nothing for what a motion has besides.
[[nodiscard]] std::optional<std::size_t> linearPlaceOf(MotionParameter parameter);

/// One family of right-hand sides, x measured from the offset of the position:
///     m x'' + b x' + k x + k3 x^3 + k1 (x - q) + Fc s(x') = F + force offset,   tau q' = x - q,
/// s the sign with sticking: at rest anything from -1 to 1, as the forces ask for. Terms that are off are not
/// there. Linear: mass, damper and spring alone.
struct MotionTerms {
    bool mass = true;
    bool spring = true;
    bool friction = false;
    bool relaxation = false;
    bool cubic = false;
    bool eachWay = false;     ///< damping and friction of their own for motion back
    bool forceOffset = false; ///< where no spring takes it up
    bool damping = true;      ///< false: a spring alone, which follows the force at once

    [[nodiscard]] std::vector<MotionParameter> parameters() const;
    friend bool operator==(const MotionTerms&, const MotionTerms&) = default;
};

/// Without its mass: b x' + k x = F.
inline constexpr MotionTerms damperAndSpring{.mass = false};

/// Of the whole family, in the units of the channels and seconds; what is off is not looked at.
struct MotionValues {
    std::array<double, motionParameters> values{};

    [[nodiscard]] double& operator[](MotionParameter parameter)
    {
        return values[static_cast<std::size_t>(parameter)];
    }
    [[nodiscard]] double operator[](MotionParameter parameter) const
    {
        return values[static_cast<std::size_t>(parameter)];
    }
    friend bool operator==(const MotionValues&, const MotionValues&) = default;
};

} // namespace gripscope
