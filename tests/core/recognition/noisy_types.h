// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/gaussian.h"
#include "core/recognition/types/type_model.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace gripscope::test {

/// Squeezes whose logs are Gaussian about a type's means with covariance S + C; C is what they say of
/// themselves.
class NoisyTypes {
public:
    NoisyTypes(std::uint64_t seed, const Eigen::Matrix3d& between)
        : m_noise(seed), m_between(between.llt().matrixL())
    {
    }

    Eigen::Vector3d normals()
    {
        Eigen::Vector3d z;
        for (double& value : z)
            value = m_noise();
        return z;
    }

    Eigen::Vector3d log(const Eigen::Vector3d& mean, const Eigen::Matrix3d& c)
    {
        return mean + m_between * normals() + Eigen::Matrix3d(c.llt().matrixL()) * normals();
    }

    static TypeSqueeze squeeze(const QString& type, const Eigen::Vector3d& log, const Eigen::Matrix3d& c)
    {
        const Eigen::Vector3d p = log.array().exp();
        return {type, {p(0), p(1), p(2)}, Eigen::Matrix3d(p.asDiagonal() * c * p.asDiagonal())};
    }

    /// Types many deviations apart.
    static Eigen::Vector3d mean(int type) { return Eigen::Vector3d(type, 0, -type); }

    std::vector<TypeSqueeze> enrolment(int types, int squeezes, const Eigen::Matrix3d& c)
    {
        std::vector<TypeSqueeze> result;
        for (int type = 0; type < types; ++type)
            for (int i = 0; i < squeezes; ++i)
                result.push_back(squeeze(QString(QChar(u'A' + type)), log(mean(type), c), c));
        return result;
    }

private:
    GaussianNoise m_noise;
    Eigen::Matrix3d m_between;
};

/// Deviations a, b, c, with this correlation between each two.
inline Eigen::Matrix3d covarianceOf(double a, double b, double c, double correlation)
{
    Eigen::Matrix3d r = Eigen::Matrix3d::Constant(correlation);
    r.diagonal().setOnes();
    const Eigen::Vector3d deviations(a, b, c);
    return deviations.asDiagonal() * r * deviations.asDiagonal();
}

} // namespace gripscope::test
