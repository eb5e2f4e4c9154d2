// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"

#include <vector>

namespace gripscope {

/// One type as it is seen from a squeeze that is to be judged.
struct TypePrediction {
    LogVector meanLog = Eigen::Vector3d::Zero();
    LogMatrix covariance = Eigen::Matrix3d::Zero(); ///< of a squeeze about the true mean, S_i + C
    double degreesOfFreedom = 0;                    ///< behind it
    double effectiveSqueezes = 1; ///< as many of the squeeze's own noise give the type's mean as well
    LogVector variance = Eigen::Vector3d::Zero(); ///< the diagonal of V
    /// d' V^-1 d, V = S_i + C + covariance of the mean, d from the mean.
    double squaredDistance = 0;
    double logDeterminant = 0; ///< of V
    /// Of the squeeze's logarithms if it is of this type: Student t in p dimensions with v - p + 1 degrees of
    /// freedom and scale V v/(v - p + 1),
    ///     ln G((v+1)/2) - ln G((v-p+1)/2) - (p/2) ln(pi v) - (1/2) ln|V| - (v+1)/2 ln(1 + d' V^-1 d / v).
    double logDensity = 0;
    double logDensityAtMean = 0; ///< the same at d = 0
    double tailDegrees = 3;      ///< v of these densities, at least p
    /// S + C where S is alike in all coordinates; absent: the squeezes speak against that.
    std::optional<LogMatrix> alikeCovariance = {};
};

/// How a squeeze is held against types.
struct PredictionOptions {
    /// For squeezes that spread unlike: each type's own covariance counts at least half from 10 squeezes on,
    /// and densities have the tails of Student's t with 5 degrees of freedom.
    bool robust = false;
};

/// One type, which need not be one of `models`, with the scatter they share. `noise`: as below.
[[nodiscard]] TypePrediction predictType(const TypeModels& models, const TypeModel& type,
                                         const LogVector& log, const std::optional<LogMatrix>& noise,
                                         const PredictionOptions& options);

/// All types in their order. `log`: in models.space, as `noise` is. `noise`: the squeeze's own covariance in
/// logs, absent where not known. `models` has at least one degree of freedom. (Murphy, Conjugate Bayesian
/// analysis of the Gaussian distribution, 2007.)
[[nodiscard]] std::vector<TypePrediction> predictTypes(const TypeModels& models, const LogVector& log,
                                                       const std::optional<LogMatrix>& noise,
                                                       const PredictionOptions& options);

} // namespace gripscope
