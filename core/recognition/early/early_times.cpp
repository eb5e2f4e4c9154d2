// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/recognition/early/early_stop.h"
#include "core/recognition/early/stranger_search.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gripscope {

namespace {

constexpr std::size_t leastSimulated = 24, mostTypes = 100;
/// Looks are sparser than a session makes them: a tenth of the time is near enough for "about 0.4 s".
constexpr double lookGrowth = 1.1;

Eigen::Vector3d drawNormals(GaussianNoise& noise)
{
    return {noise(), noise(), noise()};
}

MassDampingStiffness objectAt(const Eigen::Vector3d& logs)
{
    return {std::exp(logs(0)), std::exp(logs(1)), std::exp(logs(2))};
}

SimulationOptions simulationOptions(const EarlyDecisionOptions& decision)
{
    SimulationOptions options;
    options.sampleTime_s = decision.sampleTime_s;
    options.hold = decision.hold;
    options.lag_s = decision.lag_s;
    return options;
}

/// The deviation of white position noise under which a whole squeeze of an object has this covariance.
std::optional<double> noiseBehind(const Eigen::Matrix3d& covarianceLog, const Eigen::Vector3d& logs,
                                  const std::vector<double>& force, const EarlyDecisionOptions& decision)
{
    ContinuousTimeOptions options;
    options.sampleTime_s = decision.sampleTime_s;
    options.hold = decision.hold;
    options.lag_s = decision.lag_s;
    options.freeInitialState = decision.freeInitialState;
    options.freeOffset = decision.freeOffset;
    const MassDampingStiffness object = objectAt(logs);
    const OutputErrorProblem problem =
        makeOutputErrorProblem(force, simulate(object, force, simulationOptions(decision)), options);
    const LinearizedRecord record = linearize(problem, problem.toTheta(object));
    if (!record.finite)
        return {};
    constexpr double ridge = 1e-12; // only so that nuisances that are not free divide nothing by zero
    const Eigen::Matrix3d information = reduceRecord(record.products, 0, ridge).information;
    const double variance = (covarianceLog * information).trace() / 3;
    const double deviation = std::sqrt(variance) * problem.positionScale;
    return std::isfinite(deviation) && deviation > 0 ? std::optional(deviation) : std::nullopt;
}

/// Samples until a squeeze ends, at most all of them.
std::size_t samplesTaken(EarlyStop stop, const std::vector<double>& force,
                         const std::vector<double>& position, bool& decided)
{
    decided = false;
    for (std::size_t t = 0; t < force.size() && !decided; ++t)
        if (stop.add(force[t], position[t]))
            if (const std::optional<EarlyEnd> end = stop.look()) {
                decided = true;
                return end->samples;
            }
    return force.size();
}

} // namespace

std::optional<EarlyTimes> expectedTimes(const EarlyStopSetup& setup, const std::vector<double>& force)
{
    EarlyStopSetup sparse = setup;
    sparse.decision.growth = lookGrowth;
    sparse.chain.frameCompliance = 0; // what is simulated has none
    const EarlyStop stop(sparse);
    if (!stop.possible() || !setup.models->scatter.noiseKnown || force.empty())
        return {};
    const std::vector<CandidateType> types = candidateTypes(setup);
    const SimulationOptions simulation = simulationOptions(setup.decision);
    const std::size_t count = std::clamp(types.size(), leastSimulated, mostTypes);
    EarlyTimes times;
    std::vector<double> seconds;
    for (std::size_t i = 0; i < count; ++i) {
        // Where there are more types than squeezes, evenly among them.
        const CandidateType& type = types[types.size() > count ? i * types.size() / count : i % types.size()];
        const std::optional<double> deviation =
            noiseBehind(setup.models->scatter.noise, type.meanLog, force, setup.decision);
        if (!deviation)
            return {};
        GaussianNoise noise(i + 1);
        const Eigen::Matrix3d spread = type.covarianceLog.llt().matrixL();
        std::vector<double> position =
            simulate(objectAt(type.meanLog + spread * drawNormals(noise)), force, simulation);
        for (double& y : position)
            y += *deviation * noise();
        bool decided = false;
        const std::size_t samples = samplesTaken(stop, force, position, decided);
        times.decided += decided ? 1 : 0;
        seconds.push_back(static_cast<double>(samples) * setup.decision.sampleTime_s);
    }
    times.squeezes = static_cast<int>(count);
    std::sort(seconds.begin(), seconds.end());
    times.mean_s = std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(count);
    times.ninetyPercent_s = seconds[(9 * count - 1) / 10];
    return times;
}

} // namespace gripscope
