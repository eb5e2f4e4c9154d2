// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic_response_fit.h"

#include "core/identification/discretization.h"
#include "core/identification/fit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

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
    const Eigen::Vector3d nuisance = normal.colPivHouseholderQr().solve(right) * scale;
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
