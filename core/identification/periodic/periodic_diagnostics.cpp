// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/identification/periodic/periodic_response.h"
#include "core/identification/periodic/periodic_search.h"
#include "core/math/distributions.h"
#include "core/math/fit.h"
#include "core/math/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

using Complex = std::complex<double>;

/// P(sum > value) for a sum of this mean and variance, taken as gamma distributed.
double upperTail(double value, double mean, double variance)
{
    if (!(mean > 0) || !(variance > 0) || !std::isfinite(value))
        return std::isfinite(value) ? 1 : 0;
    return gammaAbove(std::max(value, 0.0), mean * mean / variance, variance / mean);
}

PeriodicLine measuredLine(const PeriodicProblem& problem, const LocalFit& fit)
{
    const Complex force = fit.atHarmonic(problem.spectrum.force);
    const Complex response = fit.atHarmonic(problem.spectrum.position) / force;
    const Eigen::VectorXcd noise = fit.residual(fit.gather(problem.spectrum.position)) -
                                   response * fit.residual(fit.gather(problem.spectrum.force));
    PeriodicLine line;
    line.frequency_Hz = problem.spectrum.radiansPerSample(fit.bin) / (2 * std::numbers::pi);
    line.response = response;
    line.deviation =
        std::sqrt(fit.varianceFactor * noise.squaredNorm() / fit.degreesOfFreedom) / std::abs(force);
    return line;
}

void describeNoise(const PeriodicProblem& problem, PeriodicDiagnostics& out)
{
    double force = 0;
    double position = 0;
    double coherence = 0;
    for (const LocalFit& fit : problem.lines) {
        const Eigen::VectorXcd u = fit.residual(fit.gather(problem.spectrum.force));
        const Eigen::VectorXcd y = fit.residual(fit.gather(problem.spectrum.position));
        force += u.squaredNorm() / fit.degreesOfFreedom;
        position += y.squaredNorm() / fit.degreesOfFreedom;
        const double both = u.squaredNorm() * y.squaredNorm();
        if (both > problem.noiseFloor * problem.noiseFloor) {
            // Unrelated noises have a squared coherence of 1 / v.
            const double squared = std::norm(u.dot(y)) / both;
            const double chance = 1 / fit.degreesOfFreedom;
            coherence += (squared - chance) / (1 - chance);
        }
    }
    const auto count = static_cast<double>(problem.lines.size());
    out.forceNoise = std::sqrt(force / count);
    out.positionNoise = std::sqrt(position / count);
    out.noiseCorrelation = std::sqrt(std::clamp(coherence / count, 0.0, 1.0));
}

/// On the harmonics below the highest excited one that are not excited.
void describeDistortion(const PeriodicProblem& problem, const PeriodicSearch& search,
                        PeriodicDiagnostics& out)
{
    const PeriodicResponse model(search.theta, problem.hold, problem.rest);
    const PeriodicSpectrum& spectrum = problem.spectrum;
    std::vector<Complex> error(spectrum.position.size());
    const auto fill = [&](std::size_t bin) {
        error[bin] = spectrum.position[bin] -
                     model.at(spectrum.radiansPerSample(bin), spectrum.force[bin], search.start).position;
    };
    double ratio = 0, variance = 0, excess = 0, signal = 0;
    std::size_t empty = 0;
    auto line = problem.lines.begin();
    for (std::size_t bin = spectrum.periods; bin <= problem.lines.back().bin; bin += spectrum.periods) {
        if (line->bin == bin) {
            signal += std::norm(line->atHarmonic(spectrum.position));
            ++line;
            continue;
        }
        const LocalFit fit = localFit(bin, spectrum.periods, spectrum.force.size());
        const double freedom = fit.degreesOfFreedom;
        if (freedom < 3)
            continue;
        fill(bin);
        for (const std::size_t at : fit.beside)
            fill(at);
        const double noise =
            fit.varianceFactor * fit.residual(fit.gather(error)).squaredNorm() / freedom + problem.noiseFloor;
        const double power = std::norm(fit.atHarmonic(error));
        ratio += (freedom - 1) / freedom * power / noise;
        variance += freedom / (freedom - 2);
        excess += power - noise;
        ++empty;
    }
    if (empty == 0 || !(signal > 0))
        return;
    const double emptyLines = static_cast<double>(empty);
    const double shared = emptyLines / static_cast<double>(spectrum.periods - 1);
    out.distortionPercent = 100 * std::sqrt(std::max(excess, 0.0) / signal);
    out.distortionP = upperTail(ratio, emptyLines, variance + shared);
}

/// What the position is made of: the response to the force, a unit of x0, a unit of v0 (of the range over the
/// sample time), and the offset.
struct Components {
    std::vector<double> forced, byPosition, bySpeed;
    double speed = 1;
};

Components components(const std::vector<double>& force, const PeriodicOptions& options,
                      const MassDampingStiffness& parameters)
{
    SimulationOptions simulation;
    simulation.sampleTime_s = options.sampleTime_s;
    simulation.hold = options.hold;
    simulation.lag_s = options.lag_s;
    Components out;
    out.forced = simulate(parameters, force, simulation);
    const std::vector<double> none(force.size(), 0.0);
    simulation.x0 = 1;
    out.byPosition = simulate(parameters, none, simulation);
    simulation.x0 = 0;
    simulation.v0 = out.speed = 1 / options.sampleTime_s;
    out.bySpeed = simulate(parameters, none, simulation);
    return out;
}

} // namespace

double periodicCostP(const PeriodicProblem& problem, double cost)
{
    double variance = 0;
    for (const LocalFit& line : problem.lines)
        variance += line.degreesOfFreedom / (line.degreesOfFreedom - 2);
    const auto lines = static_cast<double>(problem.lines.size());
    variance += lines / static_cast<double>(problem.spectrum.periods - 1);
    return upperTail(cost, lines - 1.5, variance);
}

PeriodicDiagnostics periodicDiagnostics(const PeriodicProblem& problem, const PeriodicSearch& search,
                                        double forceScale, double positionScale, double sampleTime_s)
{
    PeriodicDiagnostics out;
    out.periods = problem.spectrum.periods;
    out.periodSamples = problem.spectrum.samples / problem.spectrum.periods;
    for (const LocalFit& fit : problem.lines) {
        PeriodicLine line = measuredLine(problem, fit);
        line.frequency_Hz /= sampleTime_s;
        line.response *= positionScale / forceScale;
        line.deviation *= positionScale / forceScale;
        out.lines.push_back(line);
    }
    describeNoise(problem, out);
    out.forceNoise *= forceScale;
    out.positionNoise *= positionScale;
    const auto samples = static_cast<double>(problem.spectrum.samples);
    out.forceDrift = problem.spectrum.forceSlope * samples * forceScale;
    out.positionDrift = problem.spectrum.positionSlope * samples * positionScale;
    out.costRatio = search.cost.value / (static_cast<double>(problem.lines.size()) - 1.5);
    out.costP = periodicCostP(problem, search.cost.value);
    describeDistortion(problem, search, out);
    return out;
}

void fitPeriodicResponse(const std::vector<double>& force, const std::vector<double>& position,
                         const PeriodicOptions& options, Estimate& estimate)
{
    const Components parts = components(force, options, *estimate.parameters);
    const double scale = powerOfTwoScale(position);
    std::vector<bool> measured(position.size(), true);
    for (const std::size_t index : options.lost) {
        if (index < measured.size())
            measured[index] = false;
    }
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double count = 0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        if (!measured[i])
            continue;
        const Eigen::Vector3d row{parts.byPosition[i], parts.bySpeed[i], 1};
        normal += row * row.transpose();
        right += row * ((position[i] - parts.forced[i]) / scale);
        ++count;
    }
    if (!normal.allFinite() || !right.allFinite())
        return;
    const Eigen::Vector3d nuisance = solvePivoted(normal, right).solution * scale;
    std::vector<double> simulated(position.size());
    std::vector<double> residual(position.size());
    double sse = 0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        simulated[i] = parts.forced[i] + parts.byPosition[i] * nuisance(0) + parts.bySpeed[i] * nuisance(1) +
                       nuisance(2);
        residual[i] = position[i] - simulated[i];
        sse += measured[i] ? residual[i] * residual[i] : 0;
    }
    if (!nuisance.allFinite() || !allFinite(simulated) || !std::isfinite(sse))
        return;
    estimate.nuisance = {nuisance(0), nuisance(1) * parts.speed, nuisance(2)};
    estimate.residuals.sse = sse;
    estimate.residuals.degreesOfFreedom = std::max(count - 6, 0.0);
    estimate.fit.simulationPercent = fitPercent(position, simulated);
    estimate.fit.predictionPercent = estimate.fit.simulationPercent;
    estimate.simulated = std::move(simulated);
    estimate.residual = std::move(residual);
}

} // namespace gripscope
