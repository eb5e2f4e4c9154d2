// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/predictive.h"

#include "core/math/distributions.h"
#include "core/recognition/types/dimensions.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

/// Half of the weight is the type's own at 10 squeezes.
constexpr double robustLikeness = 9;
/// Student's t with 5 degrees of freedom, in the form of logDensity.
constexpr double robustDegrees = 7;

using Cholesky = Eigen::LLT<Eigen::Matrix3d>;

/// S_i + C where the type spreads in its own way: L A L' for S + C = L L'.
void takeOwnSpread(const TypeModel& type, double likeness, double types, const Cholesky& shared,
                   TypePrediction& prediction)
{
    const Eigen::Matrix3d factor = shared.matrixL();
    prediction.covariance = factor * ownCovariance(type.own, likeness) * factor.transpose();
    prediction.degreesOfFreedom = ownDegreesOfFreedom(type.own, likeness, prediction.degreesOfFreedom, types);
}

/// What depends on the degrees of freedom alone; most types share them.
class DensityConstant {
public:
    double operator()(double v)
    {
        if (v != m_degrees) {
            m_degrees = v;
            m_value = logGamma((v + 1) / 2) - logGamma((v - 2) / 2) -
                      0.5 * dimensions * std::log(std::numbers::pi * v);
        }
        return m_value;
    }

private:
    double m_degrees = 0, m_value = 0;
};

void findDensity(TypePrediction& prediction, double degreesOfFreedom, DensityConstant& constant)
{
    const double v = std::max(double(dimensions), degreesOfFreedom);
    prediction.tailDegrees = v;
    prediction.logDensityAtMean = constant(v) - prediction.logDeterminant / 2;
    prediction.logDensity =
        prediction.logDensityAtMean - (v + 1) / 2 * std::log1p(prediction.squaredDistance / v);
}

/// What a squeeze's own noise makes of the scatter that all types share.
class Predictor {
public:
    Predictor(const TypeModels& models, const std::optional<Eigen::Matrix3d>& noise,
              const PredictionOptions& options)
        : m_covariance(covarianceOfSqueeze(models.scatter, noise)), m_shared(m_covariance),
          m_precision(m_shared.solve(Eigen::Matrix3d::Identity())),
          m_degrees(degreesOfFreedom(models.scatter, m_covariance)), m_types(double(models.types.size())),
          m_likeness(models.likeness), m_robust(options.robust)
    {
        if (models.scatter.alikeVariance)
            m_alike = m_covariance - models.scatter.between +
                      *models.scatter.alikeVariance * Eigen::Matrix3d::Identity();
        if (m_robust && models.types.size() > 1)
            m_likeness = std::min(m_likeness.value_or(robustLikeness), robustLikeness);
    }

    TypePrediction operator()(const TypeModel& type, const Eigen::Vector3d& log)
    {
        TypePrediction prediction;
        prediction.meanLog = type.meanLog;
        prediction.covariance = m_covariance;
        prediction.degreesOfFreedom = m_degrees;
        // Traces of products.
        prediction.effectiveSqueezes = dimensions / m_precision.cwiseProduct(type.meanCovarianceLog).sum();
        double spread = 1;
        if (m_likeness) {
            takeOwnSpread(type, *m_likeness, m_types, m_shared, prediction);
            spread = m_precision.cwiseProduct(prediction.covariance).sum() / dimensions;
        } else {
            prediction.alikeCovariance = m_alike;
        }
        const Eigen::Matrix3d sum = prediction.covariance + spread * type.meanCovarianceLog;
        prediction.variance = sum.diagonal();
        const Cholesky total(sum);
        prediction.squaredDistance = total.matrixL().solve(log - type.meanLog).squaredNorm();
        prediction.logDeterminant = 2 * std::log(total.matrixLLT().diagonal().prod());
        findDensity(prediction,
                    m_robust ? std::min(prediction.degreesOfFreedom, robustDegrees)
                             : prediction.degreesOfFreedom,
                    m_constant);
        return prediction;
    }

private:
    Eigen::Matrix3d m_covariance;
    Cholesky m_shared;
    Eigen::Matrix3d m_precision;
    double m_degrees, m_types;
    std::optional<double> m_likeness;
    bool m_robust;
    std::optional<Eigen::Matrix3d> m_alike;
    DensityConstant m_constant;
};

} // namespace

TypePrediction predictType(const TypeModels& models, const TypeModel& type, const Eigen::Vector3d& log,
                           const std::optional<Eigen::Matrix3d>& noise, const PredictionOptions& options)
{
    return Predictor(models, noise, options)(type, log);
}

std::vector<TypePrediction> predictTypes(const TypeModels& models, const Eigen::Vector3d& log,
                                         const std::optional<Eigen::Matrix3d>& noise,
                                         const PredictionOptions& options)
{
    Predictor predict(models, noise, options);
    std::vector<TypePrediction> predictions;
    predictions.reserve(models.types.size());
    for (const TypeModel& type : models.types)
        predictions.push_back(predict(type, log));
    return predictions;
}

} // namespace gripscope
