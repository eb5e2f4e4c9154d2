// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/model/estimate.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>
#include <optional>

namespace gripscope {

/// What the object has beyond m, b and k, and the gripper's own part in it.
struct VirtualTerms {
    double friction_N = 0;       ///< Coulomb's, within the object
    double ownFriction_N = 0;    ///< of the gripper's drive, whatever it holds
    double relaxingShare = 0;    ///< k1 / k of a spring behind a dashpot
    double relaxationTime_s = 0; ///< tau of that
    double cubic = 0;            ///< k3, N/m^3; below zero: it softens

    [[nodiscard]] bool any() const
    {
        return friction_N > 0 || ownFriction_N > 0 || relaxingShare > 0 || cubic != 0;
    }
    friend bool operator==(const VirtualTerms&, const VirtualTerms&) = default;
};

/// One squeeze of a gauge study whose true variances are known: m, b and k are each their centre times
///     1 + partSpread z(part) + operatorSpread z(operator) + repeatSpread z(part, operator, trial, squeeze)
/// with independent standard normal z that `seed`, the quantity and what stands in brackets decide, so that
/// the components of variance are the squares of the spreads times the centre, and there is no interaction.
struct VirtualStudyPart {
    int part = 1, operatorNumber = 1, trial = 1;                 ///< 1 to mostOfStudy
    double partSpread = 0, operatorSpread = 0, repeatSpread = 0; ///< 0 to largestSpread
    std::uint64_t seed = 1;
    static constexpr int mostOfStudy = 1000;
    static constexpr double largestSpread = 0.1; ///< five deviations of all three stay above zero

    /// A seed for what else is random in that squeeze, which is another one for each.
    [[nodiscard]] std::uint64_t noiseSeed() const;
    friend bool operator==(const VirtualStudyPart&, const VirtualStudyPart&) = default;
};

/// What the virtual gripper holds: a kind of object whose m, b and k differ from squeeze to squeeze.
///
/// log(m, b, k) is normal. Its mean is that of the logarithms of the type's ten rows in the appendix, taken
/// to SI (paperSqueezesInSi), or what was given as "m,b,k", or
/// that of a simulated part. Its covariance is one for all: the mean of the
/// four types' covariances of logarithms, about 4 % in each of m, b, k. The tables do not tell the four apart
/// (Box's M test: p = 0.91). The appendix's scatter is made up; here it only serves as a plausible one.
class VirtualObject {
public:
    /// "A" to "D", the key of a SimulatedPart, or three numbers with commas between: m in kg (1e-6 to 1e3), b
    /// in N s/m (0 to 1e6), k in N/m (1 to 1e9). Usage otherwise.
    [[nodiscard]] static Expected<VirtualObject> fromText(const QString& text);

    /// From now on that part of a study, which scatters as the study says and in no other way.
    void takePartOf(const VirtualStudyPart& study) { m_study = study; }

    /// One without scatter; m and k positive.
    [[nodiscard]] static VirtualObject exactly(const MassDampingStiffness& centre)
    {
        VirtualObject object;
        object.m_centre = centre;
        return object;
    }

    /// The object in the hand at squeeze number `squeeze`, counted from 0: a function of the two numbers
    /// alone.
    [[nodiscard]] MassDampingStiffness draw(std::uint64_t seed, std::uint64_t squeeze) const;

    /// exp of the mean of the logarithms (the given numbers themselves for "m,b,k").
    [[nodiscard]] const MassDampingStiffness& centre() const { return m_centre; }

private:
    [[nodiscard]] MassDampingStiffness drawOfStudy(std::uint64_t squeeze) const;

    std::optional<VirtualStudyPart> m_study;
    MassDampingStiffness m_centre;
    Eigen::Matrix3d m_scatter =
        Eigen::Matrix3d::Zero(); ///< symmetric square root of the covariance of the logs
};

} // namespace gripscope
