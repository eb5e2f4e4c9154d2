// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/gaussian.h"
#include "core/recognition/types/squeeze_values.h"

#include <Eigen/Cholesky>

namespace gripscope::test {

/// The spaces of p quantities that grippers have, 1, 2, 3, 5 and 6.
inline QuantitySpace spaceOfDimensions(int p)
{
    using enum TypeQuantity;
    switch (p) {
    case 1:
        return {{Stiffness}};
    case 2:
        return {{Damping, Stiffness}};
    case 3:
        return {{Stiffness, RelaxingShare, RelaxationTime}};
    case 5:
        return {{Mass, Damping, Stiffness, RelaxingShare, RelaxationTime}};
    default:
        return {{Mass, Damping, Stiffness, RelaxingShare, RelaxationTime, Friction}};
    }
}

/// Squeezes whose logarithms are Gaussian about a type's mean: what the recognition assumes, in any space. 4
/// % of deviation, 0.3 of correlation between each two.
class SpaceTypes {
public:
    SpaceTypes(std::uint64_t seed, QuantitySpace space)
        : m_noise(seed), m_space(std::move(space)), m_factor(covariance().llt().matrixL())
    {
    }

    [[nodiscard]] LogMatrix covariance() const
    {
        const int p = m_space.dimensions();
        LogMatrix covariance = LogMatrix::Constant(p, p, 0.3 * 0.04 * 0.04);
        covariance.diagonal().setConstant(0.04 * 0.04);
        return covariance;
    }

    LogVector normals()
    {
        LogVector z(m_space.dimensions());
        for (double& value : z)
            value = m_noise();
        return z;
    }

    /// Types many deviations apart, about mass 1 and so on.
    [[nodiscard]] LogVector mean(int type) const { return LogVector::Constant(m_space.dimensions(), type); }

    LogVector log(int type) { return mean(type) + m_factor * normals(); }

    TypeSqueeze squeeze(int type) { return squeezeAt(QString(QChar(u'A' + type)), m_space, log(type)); }

    std::vector<TypeSqueeze> enrolment(int types, int squeezes)
    {
        std::vector<TypeSqueeze> result;
        for (int type = 0; type < types; ++type)
            for (int i = 0; i < squeezes; ++i)
                result.push_back(squeeze(type));
        return result;
    }

private:
    GaussianNoise m_noise;
    QuantitySpace m_space;
    LogMatrix m_factor;
};

} // namespace gripscope::test
