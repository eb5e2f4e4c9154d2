// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/type_model.h"

#include "core/math/distributions.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/scatter_estimation.h"
#include "core/recognition/types/squeeze_values.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <QHash>
#include <QMap>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// Beyond a factor exp(10) a logarithm is not known at all, and larger numbers only lose digits.
constexpr double largestLogDeviation = 10;

/// The squeezes of each type, the types by name, parts by number.
QMap<QString, std::vector<LogSqueeze>> byType(const std::vector<TypeSqueeze>& squeezes,
                                              const QuantitySpace& space)
{
    QMap<QString, std::vector<LogSqueeze>> types;
    QMap<std::pair<QString, QString>, int> parts;
    for (const TypeSqueeze& squeeze : squeezes) {
        const std::optional<LogVector> coordinates = coordinatesOf(squeeze, space);
        if (!coordinates)
            continue;
        LogSqueeze log{*coordinates, noiseOf(squeeze, space), -1};
        if (!squeeze.part.isEmpty()) {
            const auto key = std::make_pair(squeeze.type, squeeze.part);
            log.part = parts.contains(key) ? parts[key] : int(parts.size());
            parts[key] = log.part;
        }
        types[squeeze.type].push_back(std::move(log));
    }
    return types;
}

/// A type's scatter about its own mean in units of what the shared model expects of it.
OwnScatter ownScatter(const Scatter& scatter, const std::vector<LogSqueeze>& squeezes)
{
    OwnScatter own;
    own.sum = LogMatrix::Zero(scatter.total.rows(), scatter.total.rows());
    const PartScatter parts = partScatter({squeezes});
    if (parts.betweenDegrees == 0)
        return own;
    const LogMatrix expected = covarianceOfSqueeze(scatter, parts.noise);
    const Eigen::LLT<LogMatrix> cholesky(expected);
    if (cholesky.info() != Eigen::Success)
        return own;
    const LogMatrix total = parts.between + (1 - parts.meanInverse) * parts.within;
    const LogMatrix half = cholesky.matrixL().solve(total);
    own.degreesOfFreedom = parts.betweenDegrees;
    own.sum = own.degreesOfFreedom * cholesky.matrixL().solve(half.transpose().eval());
    return own;
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
    const double quantile = chiSquaredQuantile(share, 3);
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

std::optional<Eigen::Matrix3d> logCovariance(const MassDampingStiffness& p, const Eigen::Matrix3d& covariance)
{
    if (!isUsable(p) || !covariance.allFinite())
        return {};
    Eigen::Matrix3d log;
    const Eigen::Vector3d x = p.vector();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            log(i, j) = (covariance(i, j) / x(i) + covariance(j, i) / x(i)) / x(j) / 2;
    const std::optional<LogMatrix> usable = usableLogCovariance(log);
    return usable ? std::optional<Eigen::Matrix3d>(*usable) : std::nullopt;
}

std::optional<LogMatrix> usableLogCovariance(const LogMatrix& covariance)
{
    LogMatrix log = covariance;
    LogVector scale(log.rows());
    for (Eigen::Index i = 0; i < log.rows(); ++i) {
        if (!(log(i, i) >= 0) || !std::isfinite(log(i, i)))
            return {};
        scale(i) = std::min(1.0, largestLogDeviation / std::sqrt(log(i, i)));
    }
    log = scale.asDiagonal() * log * scale.asDiagonal();
    // Rounding may leave a covariance of less than full rank with an eigenvalue just below zero.
    LogMatrix lifted = log;
    lifted.diagonal() *= 1 + 1e-9;
    lifted.diagonal().array() += 1e-30;
    if (!log.allFinite() || lifted.llt().info() != Eigen::Success)
        return {};
    return lifted;
}

TypeModels fitTypeModels(const std::vector<TypeSqueeze>& squeezes, const QuantitySpace& space)
{
    const QMap<QString, std::vector<LogSqueeze>> logs = byType(squeezes, space);
    const std::vector<std::vector<LogSqueeze>> groups(logs.cbegin(), logs.cend());
    QHash<QString, int> places;
    for (const TypeSqueeze& squeeze : squeezes)
        places.insert(squeeze.type, squeeze.place);
    TypeModels models;
    models.space = space;
    models.scatter = estimateScatter(groups, QuantitySpace{}.contains(space));
    models.covarianceLog = models.scatter.total;
    models.degreesOfFreedom = int(models.scatter.degreesOfFreedom + 1e-6);
    models.shrinkage = models.scatter.shrinkage;
    std::vector<OwnScatter> own;
    for (auto it = logs.cbegin(); it != logs.cend(); ++it) {
        TypeModel type;
        type.name = it.key();
        type.squeezes = int(it->size());
        const int place = places.value(it.key(), -1);
        type.place = place >= 0 ? place : int(models.types.size());
        const TypeMean mean = estimateMean(models.scatter, *it);
        type.meanLog = mean.mean;
        type.meanCovarianceLog = mean.covariance;
        type.own = ownScatter(models.scatter, *it);
        own.push_back(type.own);
        models.types.push_back(std::move(type));
    }
    models.likeness = degreesOfLikeness(own);
    return models;
}

std::optional<double> falseRejectGate(double squeezesOfType, double degreesOfFreedom, double rate,
                                      int dimensions)
{
    const std::optional<double> gate = predictiveGate(degreesOfFreedom, rate, dimensions);
    if (!gate || !(squeezesOfType > 0))
        return {};
    return (1 + 1 / squeezesOfType) * *gate;
}

std::optional<double> squaredDistance(const TypeModels& models, const TypeModel& type,
                                      const TypeSqueeze& squeeze)
{
    const std::optional<LogVector> log = coordinatesOf(squeeze, models.space);
    if (models.degreesOfFreedom == 0 || !log)
        return {};
    const LogVector difference = *log - type.meanLog;
    return difference.dot(models.covarianceLog.llt().solve(difference));
}

std::optional<double> squaredDistance(const TypeModels& models, const TypeModel& type,
                                      const MassDampingStiffness& p)
{
    return squaredDistance(models, type, TypeSqueeze{{}, p});
}

std::optional<Ellipsoid> typeEllipsoid(const TypeModels& models, const TypeModel& type, double share)
{
    if (models.degreesOfFreedom == 0 || models.space != QuantitySpace{})
        return {};
    const Eigen::Vector3d centre = type.meanLog.array().exp();
    return ellipsoid(centre, centre.asDiagonal() * models.covarianceLog * centre.asDiagonal(), share);
}

std::optional<Ellipsoid> estimateEllipsoid(const MassDampingStiffness& p, const Eigen::Matrix3d& covariance,
                                           double share)
{
    return ellipsoid(p.vector(), covariance, share);
}

std::vector<TypeInterval> typeIntervals(const TypeModels& models, const TypeModel& type, double share)
{
    if (!(share >= 0.5 && share <= 0.9999))
        share = 0.95;
    const double z = normalQuantile(0.5 + share / 2);
    std::vector<TypeInterval> intervals;
    for (Eigen::Index row = 0; row < type.meanLog.size(); ++row) {
        const double spread = z * std::sqrt(std::max(0.0, models.covarianceLog(row, row)));
        const double mean = type.meanLog(row);
        intervals.push_back({std::exp(mean), std::exp(mean - spread), std::exp(mean + spread)});
    }
    return intervals;
}

} // namespace gripscope
