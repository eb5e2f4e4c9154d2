// SPDX-License-Identifier: GPL-3.0-or-later
// What a verdict costs, and a look at a squeeze that may end early.
#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/recognition/early/early_stop.h"
#include "core/signal/excitation/excitation.h"

#include <benchmark/benchmark.h>
#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const Eigen::Vector3d relativeErrors(0.004, 0.004, 0.001);

Eigen::Matrix3d covarianceOf(const MassDampingStiffness& parameters)
{
    const Eigen::Vector3d deviations = relativeErrors.cwiseProduct(parameters.vector());
    return deviations.cwiseAbs2().asDiagonal();
}

/// Ten squeezes of each of `types` types, spread over a decade in m, b and k, 3 % of scatter.
std::vector<TypeSqueeze> enrolment(int types)
{
    GaussianNoise noise(1);
    std::vector<TypeSqueeze> squeezes;
    for (int type = 0; type < types; ++type) {
        const double m = 0.02 * std::pow(10, noise.uniform());
        const double b = 20 * std::pow(10, noise.uniform());
        const double k = 3000 * std::pow(10, noise.uniform());
        for (int i = 0; i < 10; ++i) {
            TypeSqueeze squeeze{u"type %1"_s.arg(type), {}};
            squeeze.parameters.m = m * std::exp(0.03 * noise());
            squeeze.parameters.b = b * std::exp(0.03 * noise());
            squeeze.parameters.k = k * std::exp(0.03 * noise());
            squeeze.covariance = covarianceOf(squeeze.parameters);
            squeezes.push_back(squeeze);
        }
    }
    return squeezes;
}

/// A verdict from an estimate and its covariance, the models fitted before.
void judgeAmongTypes(benchmark::State& state)
{
    const std::vector<TypeSqueeze> squeezes = enrolment(static_cast<int>(state.range(0)));
    const TypeModels models = fitTypeModels(squeezes);
    std::size_t next = 0;
    for (auto _ : state) {
        const TypeSqueeze& squeeze = squeezes[next++ % squeezes.size()];
        benchmark::DoNotOptimize(judge(models, squeeze.parameters, {}, squeeze.covariance));
    }
}
BENCHMARK(judgeAmongTypes)->Arg(4)->Arg(100)->Unit(benchmark::kMicrosecond);

/// One look at so many samples of a squeeze at 2 kHz: among 4 types, and among 100.
void lookAtASqueeze(benchmark::State& state)
{
    EarlyStopSetup setup;
    setup.models =
        std::make_shared<const TypeModels>(fitTypeModels(enrolment(static_cast<int>(state.range(0)))));
    setup.decision.sampleTime_s = 0.0005;
    setup.decision.hold = ForceHold::Zero;
    ExcitationOptions excitation;
    excitation.samples = static_cast<std::size_t>(state.range(1));
    const std::vector<double> force = *makeExcitation(excitation);
    std::vector<double> position = simulate({0.0396, 43, 9990}, force, {0.0005, ForceHold::Zero, 0, 0, 0, 0});
    GaussianNoise noise(1);
    EarlyStop stop(setup);
    for (std::size_t t = 0; t < force.size(); ++t)
        stop.add(force[t], position[t] + 5e-6 * noise());
    for (auto _ : state)
        benchmark::DoNotOptimize(stop.look());
}
BENCHMARK(lookAtASqueeze)->Args({4, 200})->Args({4, 2000})->Args({100, 200})->Unit(benchmark::kMillisecond);

} // namespace
