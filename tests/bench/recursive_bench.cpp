// SPDX-License-Identifier: GPL-3.0-or-later
// What following a squeeze costs: each sample counted in and the estimate with its covariance read.
#include "core/identification/model/discretization.h"
#include "core/identification/recursive/recursive_estimator.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"

#include <benchmark/benchmark.h>

using namespace gripscope;

namespace {

/// Can A in SI at 2 kHz with 10 um of position noise.
struct Squeeze {
    std::vector<double> force, position;

    explicit Squeeze(std::size_t samples)
    {
        ExcitationOptions excitation;
        excitation.samples = samples;
        force = *makeExcitation(excitation);
        position = simulate({0.0396, 43, 9990}, force,
                            {excitation.sampleTime_s, ForceHold::Zero, 0, 0.001, 0, 0.01});
        GaussianNoise noise(1);
        for (double& y : position)
            y += 1e-5 * noise();
    }
};

RecursiveOptions options(bool given)
{
    RecursiveOptions result;
    result.sampleTime_s = 0.0005;
    result.hold = ForceHold::Zero;
    if (given)
        result.start = MassDampingStiffness{0.05, 30, 12000};
    return result;
}

/// From the first sample on, the start included; the time an item is that of one sample.
void follow(benchmark::State& state)
{
    const Squeeze squeeze(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        RecursiveEstimator estimator(options(state.range(1) != 0));
        for (std::size_t i = 0; i < squeeze.force.size(); ++i) {
            estimator.update(squeeze.force[i], squeeze.position[i]);
            benchmark::DoNotOptimize(estimator.state());
        }
    }
    state.counters["sample"] = benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)),
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Once the estimate stands.
void followOn(benchmark::State& state)
{
    const Squeeze squeeze(20000);
    RecursiveEstimator started(options(true));
    for (std::size_t i = 0; i < 10000; ++i)
        started.update(squeeze.force[i], squeeze.position[i]);
    for (auto _ : state) {
        RecursiveEstimator estimator = started;
        for (std::size_t i = 10000; i < 20000; ++i) {
            estimator.update(squeeze.force[i], squeeze.position[i]);
            benchmark::DoNotOptimize(estimator.state());
        }
    }
    state.counters["sample"] = benchmark::Counter(static_cast<double>(state.iterations() * 10000),
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(follow)->Args({2000, 1})->Args({2000, 0})->Args({20000, 1})->Unit(benchmark::kMillisecond);
BENCHMARK(followOn)->Unit(benchmark::kMillisecond);

} // namespace
