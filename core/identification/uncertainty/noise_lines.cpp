// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/words.h"
#include "core/identification/model/discretization.h"
#include "core/identification/uncertainty/budget_lines.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Lags at which the residuals' noise model is held against the noise that is stated.
constexpr std::size_t comparedLags = 10;
using Autocovariance = std::array<double, comparedLags + 1>; ///< at lags 0, 1, ...

Autocovariance autocovarianceOf(const std::vector<double>& impulseResponse)
{
    Autocovariance out{};
    for (std::size_t lag = 0; lag < out.size(); ++lag)
        for (std::size_t t = lag; t < impulseResponse.size(); ++t)
            out[lag] += impulseResponse[t] * impulseResponse[t - lag];
    return out;
}

/// What white noise of standard deviation 1 on the force does to (ln m, ln b, ln k), and to the position: the
/// model's impulse response g runs through the projected sensitivities backwards.
struct ForceNoiseEffect {
    Eigen::Matrix3d relative = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d whiteRelative = Eigen::Matrix3d::Zero(); ///< of unit white noise of the position itself
    Autocovariance position{};
};

/// Whether the noise model of the residuals is what `stated` noise colours them with: at every lag within
/// three standard errors 1 / sqrt(n) of an autocorrelation.
bool explains(const Autocovariance& stated, double residualVariance, const AutoregressiveNoise& found,
              double samples)
{
    // The model's impulse response, as far as ten lags of its autocovariance need it.
    std::vector<double> response(1000, 0.0);
    for (std::size_t t = 0; t < response.size(); ++t) {
        if (t <= found.movingAverage.size())
            response[t] = t == 0 ? 1 : found.movingAverage[t - 1];
        for (std::size_t i = 0; i < std::min(t, found.coefficients.size()); ++i)
            response[t] += found.coefficients[i] * response[t - 1 - i];
    }
    const Autocovariance coloured = autocovarianceOf(response);
    const double room = 3 / std::sqrt(samples);
    for (std::size_t lag = 1; lag < stated.size(); ++lag)
        if (!(std::abs(coloured[lag] / coloured[0] - stated[lag] / residualVariance) < room))
            return false;
    return true;
}

ForceNoiseEffect forceNoiseEffect(const Estimate& e, const LinearizedRecord& record,
                                  const OutputErrorOptions& options)
{
    const std::size_t samples = record.velocity.size();
    std::vector<double> impulse(samples, 0.0);
    impulse.front() = 1;
    const SimulationOptions rest{options.sampleTime_s, options.hold, options.lag_s, 0, 0, 0};
    ForceNoiseEffect out;
    out.position = autocovarianceOf(simulate(*e.parameters, impulse, rest));

    const Eigen::MatrixXd influence = influences(record);
    Eigen::MatrixXd answered(static_cast<Eigen::Index>(samples), 3);
    for (Eigen::Index i = 0; i < 3; ++i) {
        std::vector<double> backwards(samples, 0.0);
        for (std::size_t r = 0; r < record.rows.size(); ++r)
            backwards[samples - 1 - record.rows[r]] = influence(static_cast<Eigen::Index>(r), i);
        const std::vector<double> filtered = simulate(*e.parameters, backwards, rest);
        for (std::size_t t = 0; t < samples; ++t)
            answered(static_cast<Eigen::Index>(t), i) = filtered[t];
    }
    out.relative = answered.transpose() * answered;
    out.whiteRelative = influence.transpose() * influence;
    return out;
}

bool isColoured(const Estimate& estimate)
{
    return estimate.noise && !estimate.noise->coefficients.empty();
}

/// What the residuals tell of the noise of both channels together.
BudgetLine residualNoise(const Estimate& estimate)
{
    BudgetLine noise;
    noise.type = EvaluationType::A;
    noise.covariance = *estimate.covariance;
    const double degreesOfFreedom = std::max(estimate.residuals.degreesOfFreedom, 1.0);
    const double inflation = std::max(estimate.residuals.errorInflation.value_or(1), 1.0);
    const bool coloured = isColoured(estimate);
    const double independent = coloured ? degreesOfFreedom / (inflation * inflation) : degreesOfFreedom;
    noise.degreesOfFreedom = Eigen::Vector3d::Constant(std::max(independent, 1.0));
    noise.id = coloured ? u"noise"_s : u"position_noise"_s;
    noise.words =
        coloured ? Words::say("noise of position and force, correlated over time (an autoregressive model of "
                              "order %1)")
                       .arg(estimate.noise->coefficients.size())
                 : Words::say("white noise of the position");
    return noise;
}

} // namespace

std::vector<BudgetLine> noiseLines(const Estimate& estimate, const LinearizedRecord& record,
                                   const OutputErrorOptions& options, double forceNoiseDeviation)
{
    const BudgetLine both = residualNoise(estimate);
    if (!(forceNoiseDeviation > 0) || !record.usable())
        return {both};
    ForceNoiseEffect effect = forceNoiseEffect(estimate, record, options);
    const double variance = forceNoiseDeviation * forceNoiseDeviation;
    const Eigen::Vector3d p = estimate.parameters->vector();
    const BudgetLine force = lineOf(
        u"force_noise"_s, Words::say("white noise of the force, as stated or measured before the squeeze"),
        EvaluationType::B, p, variance * effect.relative);
    const double degreesOfFreedom = std::max(estimate.residuals.degreesOfFreedom, 1.0);
    const double residual = estimate.residuals.sse / degreesOfFreedom;
    if (!force.covariance.allFinite() || !effect.whiteRelative.allFinite() || !(residual > 0))
        return {both};
    for (double& value : effect.position)
        value *= variance;
    BudgetLine position =
        lineOf(u"position_noise"_s, Words::say("white noise of the position"), EvaluationType::A, p,
               std::max(residual - effect.position[0], 0.0) * effect.whiteRelative);
    position.degreesOfFreedom = Eigen::Vector3d::Constant(degreesOfFreedom);
    // Where something else colours the residuals, with or without the noise that is stated, the larger of the
    // two answers holds.
    const auto relativeSize = [&p](const Eigen::Matrix3d& covariance) {
        return covariance.diagonal().cwiseQuotient(p.cwiseAbs2()).sum();
    };
    if (isColoured(estimate) &&
        !explains(effect.position, residual, *estimate.noise, static_cast<double>(record.rows.size())) &&
        relativeSize(both.covariance) > relativeSize(position.covariance + force.covariance))
        return {both};
    return {position, force};
}

} // namespace gripscope
