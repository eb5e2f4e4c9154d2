// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/predictive.h"

#include "core/recognition/quiet_policy.h"

#include <Eigen/Cholesky>
#include <boost/math/special_functions/gamma.hpp> // std::lgamma writes a global

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

constexpr double dimensions = 3;
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
            m_value = boost::math::lgamma((v + 1) / 2, QuietPolicy()) -
                      boost::math::lgamma((v - 2) / 2, QuietPolicy()) -
                      dimensions / 2 * std::log(std::numbers::pi * v);
        }
        return m_value;
    }

private:
    double m_degrees = 0, m_value = 0;
};

void findDensity(TypePrediction& prediction, double degreesOfFreedom, DensityConstant& constant)
{
    const double v = std::max(dimensions, degreesOfFreedom);
    prediction.tailDegrees = v;
    prediction.logDensityAtMean = constant(v) - prediction.logDeterminant / 2;
    prediction.logDensity =
        prediction.logDensityAtMean - (v + 1) / 2 * std::log1p(prediction.squaredDistance / v);
}

} // namespace

std::vector<TypePrediction> predictTypes(const TypeModels& models, const Eigen::Vector3d& log,
                                         const std::optional<Eigen::Matrix3d>& noise,
                                         const PredictionOptions& options)
{
    const Eigen::Matrix3d sharedCovariance = covarianceOfSqueeze(models.scatter, noise);
    const Cholesky shared(sharedCovariance);
    const Eigen::Matrix3d precision = shared.solve(Eigen::Matrix3d::Identity());
    const double degrees = degreesOfFreedom(models.scatter, sharedCovariance);
    std::optional<double> likeness = models.likeness;
    std::optional<Eigen::Matrix3d> alike;
    if (models.scatter.alikeVariance)
        alike = sharedCovariance - models.scatter.between +
                *models.scatter.alikeVariance * Eigen::Matrix3d::Identity();
    if (options.robust && models.types.size() > 1)
        likeness = std::min(likeness.value_or(robustLikeness), robustLikeness);
    std::vector<TypePrediction> predictions;
    predictions.reserve(models.types.size());
    DensityConstant constant;
    for (const TypeModel& type : models.types) {
        TypePrediction prediction;
        prediction.meanLog = type.meanLog;
        prediction.covariance = sharedCovariance;
        prediction.degreesOfFreedom = degrees;
        // Traces of products.
        prediction.effectiveSqueezes = dimensions / precision.cwiseProduct(type.meanCovarianceLog).sum();
        double spread = 1;
        if (likeness) {
            takeOwnSpread(type, *likeness, double(models.types.size()), shared, prediction);
            spread = precision.cwiseProduct(prediction.covariance).sum() / dimensions;
        } else {
            prediction.alikeCovariance = alike;
        }
        const Cholesky total(prediction.covariance + spread * type.meanCovarianceLog);
        prediction.squaredDistance = total.matrixL().solve(log - type.meanLog).squaredNorm();
        prediction.logDeterminant = 2 * std::log(total.matrixLLT().diagonal().prod());
        findDensity(prediction,
                    options.robust ? std::min(prediction.degreesOfFreedom, robustDegrees)
                                   : prediction.degreesOfFreedom,
                    constant);
        predictions.push_back(prediction);
    }
    return predictions;
}

} // namespace gripscope
