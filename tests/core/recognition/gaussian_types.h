// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"

#include <Eigen/Cholesky>
#include <boost/math/distributions/normal.hpp>

#include <cmath>
#include <random>

namespace gripscope::test {

/// Squeezes whose logs are Gaussian about a type's means, with one covariance for all types: what the
/// recognition assumes. Normal numbers come from the quantile function, so that they are the same on every
/// machine.
class GaussianTypes {
public:
    /// `correlation`: between each two of log m, log b, log k; `deviation`: of each.
    GaussianTypes(std::uint64_t seed, double correlation, double deviation = 0.04) : m_random(seed)
    {
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Constant(correlation * deviation * deviation);
        covariance.diagonal().setConstant(deviation * deviation);
        m_factor = covariance.llt().matrixL();
    }

    Eigen::Vector3d normals()
    {
        Eigen::Vector3d z;
        for (double& value : z)
            value = boost::math::quantile(m_normal, (double(m_random() >> 11) + 0.5) * 0x1p-53);
        return z;
    }

    /// A squeeze of the type whose logs lie about (type, 0, -type): types are many deviations apart.
    MassDampingStiffness squeeze(int type)
    {
        const Eigen::Vector3d x = Eigen::Vector3d(type, 0, -type) + m_factor * normals();
        return {std::exp(x(0)), std::exp(x(1)), std::exp(x(2))};
    }

    std::vector<TypeSqueeze> enrolment(int types, int squeezes)
    {
        std::vector<TypeSqueeze> result;
        for (int type = 0; type < types; ++type)
            for (int i = 0; i < squeezes; ++i)
                result.push_back({QString(QChar(u'A' + type)), squeeze(type)});
        return result;
    }

private:
    std::mt19937_64 m_random;
    boost::math::normal m_normal;
    Eigen::Matrix3d m_factor;
};

} // namespace gripscope::test
