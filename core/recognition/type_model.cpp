// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/type_model.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <QMap>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr int dimensions = 3;

/// No instrument repeats better than to a ten-thousandth. It keeps squeezes that are copies of each other (a
/// file enrolled twice) from giving a covariance of zero.
constexpr double leastScatter = 1e-4;

/// Keeps the covariance invertible in double precision when m, b and k of many squeezes go exactly together.
constexpr double leastShrinkage = 1e-10;

/// Errors as values, not exceptions.
using QuietPolicy = boost::math::policies::policy<
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;

bool usable(const MassDampingStiffness& p)
{
    return std::isfinite(p.m) && std::isfinite(p.b) && std::isfinite(p.k) && p.m > 0 && p.b > 0 && p.k > 0;
}

Eigen::Vector3d logOf(const MassDampingStiffness& p)
{
    return p.vector().array().log();
}

/// Within-type sums of squares and products, over v degrees of freedom.
Eigen::Matrix3d pooledCovariance(const QMap<QString, std::vector<Eigen::Vector3d>>& logs,
                                 const std::vector<TypeModel>& types, int degreesOfFreedom)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const TypeModel& type : types)
        for (const Eigen::Vector3d& x : logs[type.name])
            sum += (x - type.meanLog) * (x - type.meanLog).transpose();
    Eigen::Matrix3d covariance = sum / degreesOfFreedom;
    covariance.diagonal() = covariance.diagonal().cwiseMax(leastScatter * leastScatter);
    return covariance;
}

/// centre + {x : x' covariance^-1 x <= q}, from a Cholesky factor L = U S V', covariance = U S^2 U': the
/// variances of m and k differ by 1e11 in SI, and the roots keep digits that squares would lose.
std::optional<Ellipsoid> ellipsoid(const Eigen::Vector3d& centre, const Eigen::Matrix3d& covariance,
                                   double share)
{
    if (!centre.allFinite() || !covariance.allFinite() || !(share > 0 && share < 1))
        return {};
    const Eigen::LLT<Eigen::Matrix3d> cholesky(covariance);
    if (cholesky.info() != Eigen::Success)
        return {};
    const Eigen::Matrix3d factor = cholesky.matrixL();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(factor, Eigen::ComputeFullU);
    const double quantile = boost::math::quantile(boost::math::chi_squared(dimensions), share);
    Ellipsoid result;
    result.centre = centre;
    result.axes = svd.matrixU();
    result.radii = std::sqrt(quantile) * svd.singularValues();
    return result;
}

} // namespace

const TypeModel* TypeModels::find(const QString& name) const
{
    const auto it =
        std::find_if(types.begin(), types.end(), [&](const TypeModel& type) { return type.name == name; });
    return it == types.end() ? nullptr : &*it;
}

TypeModels fitTypeModels(const std::vector<TypeSqueeze>& squeezes)
{
    QMap<QString, std::vector<Eigen::Vector3d>> logs;
    for (const TypeSqueeze& squeeze : squeezes)
        if (usable(squeeze.parameters))
            logs[squeeze.type].push_back(logOf(squeeze.parameters));
    TypeModels models;
    for (auto it = logs.cbegin(); it != logs.cend(); ++it) {
        TypeModel type;
        type.name = it.key();
        type.squeezes = int(it->size());
        for (const Eigen::Vector3d& x : *it)
            type.meanLog += x / double(it->size());
        models.degreesOfFreedom += type.squeezes - 1;
        models.types.push_back(std::move(type));
    }
    if (models.degreesOfFreedom == 0)
        return models;
    const double v = models.degreesOfFreedom;
    models.shrinkage = std::max(leastShrinkage, 1 / (1 + v * v * v));
    const Eigen::Matrix3d pooled = pooledCovariance(logs, models.types, models.degreesOfFreedom);
    models.covarianceLog = (1 - models.shrinkage) * pooled;
    models.covarianceLog.diagonal() = pooled.diagonal();
    return models;
}

std::optional<double> falseRejectGate(int squeezesOfType, int degreesOfFreedom, double rate)
{
    const double v = degreesOfFreedom;
    if (squeezesOfType < 1 || degreesOfFreedom < dimensions || !(rate > 0 && rate < 1))
        return {};
    const boost::math::fisher_f_distribution<double, QuietPolicy> f(dimensions, v - 2);
    const double quantile = boost::math::quantile(boost::math::complement(f, rate));
    const double gate = (1 + 1.0 / squeezesOfType) * dimensions * v / (v - 2) * quantile;
    return std::isfinite(gate) ? std::optional(gate)
                               : std::nullopt; // infinite for a rate next to 0 and v = 3
}

std::optional<double> squaredDistance(const TypeModels& models, const TypeModel& type,
                                      const MassDampingStiffness& p)
{
    if (models.degreesOfFreedom == 0 || !usable(p))
        return {};
    const Eigen::Vector3d difference = logOf(p) - type.meanLog;
    return difference.dot(models.covarianceLog.llt().solve(difference));
}

std::optional<Ellipsoid> typeEllipsoid(const TypeModels& models, const TypeModel& type, double share)
{
    if (models.degreesOfFreedom == 0)
        return {};
    const Eigen::Vector3d centre = type.meanLog.array().exp();
    return ellipsoid(centre, centre.asDiagonal() * models.covarianceLog * centre.asDiagonal(), share);
}

std::optional<Ellipsoid> estimateEllipsoid(const MassDampingStiffness& p, const Eigen::Matrix3d& covariance,
                                           double share)
{
    return ellipsoid(p.vector(), covariance, share);
}

} // namespace gripscope
