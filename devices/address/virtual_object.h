// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/model/estimate.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>

namespace gripscope {

/// What the virtual gripper holds: a kind of object whose m, b and k differ from squeeze to squeeze.
///
/// log(m, b, k) is normal. Its mean is that of the logarithms of the type's ten rows in the appendix, taken
/// to SI (paperSqueezesInSi), or what was given as "m,b,k". Its covariance is one for all: the mean of the
/// four types' covariances of logarithms, about 4 % in each of m, b, k. The tables do not tell the four apart
/// (Box's M test: p = 0.91). The appendix's scatter is made up; here it only serves as a plausible one.
class VirtualObject {
public:
    /// "A" to "D", or three numbers with commas between: m in kg (1e-6 to 1e3), b in N s/m (0 to 1e6), k in
    /// N/m (1 to 1e9). Usage otherwise.
    [[nodiscard]] static Expected<VirtualObject> fromText(const QString& text);

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
    MassDampingStiffness m_centre;
    Eigen::Matrix3d m_scatter =
        Eigen::Matrix3d::Zero(); ///< symmetric square root of the covariance of the logs
};

} // namespace gripscope
