// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/predictive.h"

#include "core/math/distributions.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

/// Of this many more than p: at 10 squeezes the type's own sum is nine of (nu - p - 1) I + A, the prior's
/// five.
constexpr double robustLikeness = 6;
/// Student's t with 5 degrees of freedom, in the form of logDensity: this many more than p.
constexpr double robustDegrees = 4;

using Cholesky = Eigen::LLT<LogMatrix>;

/// S_i + C where the type spreads in its own way: L A L' for S + C = L L'.
void takeOwnSpread(const TypeModel& type, double likeness, double types, const Cholesky& shared,
                   TypePrediction& prediction)
{
    const LogMatrix factor = shared.matrixL();
    prediction.covariance = factor * ownCovariance(type.own, likeness) * factor.transpose();
    prediction.degreesOfFreedom = ownDegreesOfFreedom(type.own, likeness, prediction.degreesOfFreedom, types);
}

/// What depends on the degrees of freedom alone; most types share them.
class DensityConstant {
public:
    explicit DensityConstant(double dimensions) : m_dimensions(dimensions) {}
    double operator()(double v)
    {
        if (v != m_degrees) {
            m_degrees = v;
            m_value = logGamma((v + 1) / 2) - logGamma((v - (m_dimensions - 1)) / 2) -
                      0.5 * m_dimensions * std::log(std::numbers::pi * v);
        }
        return m_value;
    }

private:
    double m_dimensions, m_degrees = 0, m_value = 0;
};

void findDensity(TypePrediction& prediction, double degreesOfFreedom, DensityConstant& constant)
{
    const double v = std::max(double(prediction.meanLog.size()), degreesOfFreedom);
    prediction.tailDegrees = v;
    prediction.logDensityAtMean = constant(v) - prediction.logDeterminant / 2;
    prediction.logDensity =
        prediction.logDensityAtMean - (v + 1) / 2 * std::log1p(prediction.squaredDistance / v);
}

/// What a squeeze's own noise makes of the scatter that all types share.
class Predictor {
public:
    Predictor(const TypeModels& models, const std::optional<LogMatrix>& noise,
              const PredictionOptions& options)
        : m_covariance(covarianceOfSqueeze(models.scatter, noise)), m_shared(m_covariance),
          m_precision(m_shared.solve(LogMatrix::Identity(m_covariance.rows(), m_covariance.rows()))),
          m_degrees(degreesOfFreedom(models.scatter, m_covariance)), m_types(double(models.types.size())),
          m_likeness(models.likeness), m_robust(options.robust), m_constant(double(m_covariance.rows()))
    {
        if (models.scatter.alikeVariance)
            m_alike =
                m_covariance - models.scatter.between +
                *models.scatter.alikeVariance * LogMatrix::Identity(m_covariance.rows(), m_covariance.rows());
        const double robustly = dimensions() + robustLikeness;
        if (m_robust && models.types.size() > 1)
            m_likeness = std::min(m_likeness.value_or(robustly), robustly);
    }

    TypePrediction operator()(const TypeModel& type, const LogVector& log)
    {
        TypePrediction prediction;
        prediction.meanLog = type.meanLog;
        prediction.covariance = m_covariance;
        prediction.degreesOfFreedom = m_degrees;
        // Traces of products.
        prediction.effectiveSqueezes = dimensions() / m_precision.cwiseProduct(type.meanCovarianceLog).sum();
        double spread = 1;
        if (m_likeness) {
            takeOwnSpread(type, *m_likeness, m_types, m_shared, prediction);
            spread = m_precision.cwiseProduct(prediction.covariance).sum() / dimensions();
        } else {
            prediction.alikeCovariance = m_alike;
        }
        const LogMatrix sum = prediction.covariance + spread * type.meanCovarianceLog;
        prediction.variance = sum.diagonal();
        const Cholesky total(sum);
        prediction.squaredDistance = total.matrixL().solve(log - type.meanLog).squaredNorm();
        prediction.logDeterminant = 2 * std::log(total.matrixLLT().diagonal().prod());
        findDensity(prediction,
                    m_robust ? std::min(prediction.degreesOfFreedom, dimensions() + robustDegrees)
                             : prediction.degreesOfFreedom,
                    m_constant);
        return prediction;
    }

private:
    [[nodiscard]] double dimensions() const { return double(m_covariance.rows()); }

    LogMatrix m_covariance;
    Cholesky m_shared;
    LogMatrix m_precision;
    double m_degrees, m_types;
    std::optional<double> m_likeness;
    bool m_robust;
    std::optional<LogMatrix> m_alike;
    DensityConstant m_constant;
};

} // namespace

TypePrediction predictType(const TypeModels& models, const TypeModel& type, const LogVector& log,
                           const std::optional<LogMatrix>& noise, const PredictionOptions& options)
{
    return Predictor(models, noise, options)(type, log);
}

std::vector<TypePrediction> predictTypes(const TypeModels& models, const LogVector& log,
                                         const std::optional<LogMatrix>& noise,
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
