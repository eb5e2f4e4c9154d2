// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/feature_scaling.h"
#include "core/clustering/kmeans.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/verdict/verdict.h"
#include "core/research/paper_reproduction.h"

#include <benchmark/benchmark.h>

namespace gripscope {

namespace {

/// Ten restarts on the paper's 40 squeezes: what the Types page asks for at each change of a choice.
void clusterAppendix(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(clusterPaperAppendix(FeatureScaling::ZScore));
}
BENCHMARK(clusterAppendix)->Unit(benchmark::kMicrosecond);

/// A plant's year: many items on a fixed pattern around four centres.
void clusterMany(benchmark::State& state)
{
    Eigen::MatrixXd items(state.range(0), 3);
    for (Eigen::Index i = 0; i < items.rows(); ++i)
        for (Eigen::Index j = 0; j < 3; ++j)
            items(i, j) = 10.0 * double((i % 4) == j) + double((i * 7919 + j * 104729) % 1000) / 1000;
    for (auto _ : state)
        benchmark::DoNotOptimize(kMeans(items));
}
BENCHMARK(clusterMany)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

/// A verdict as an inspection asks for it, the models fitted before.
void judgeOneSqueeze(benchmark::State& state)
{
    const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
    const TypeModels models = fitTypeModels(squeezes);
    for (auto _ : state)
        benchmark::DoNotOptimize(judge(models, squeezes.front().parameters));
}
BENCHMARK(judgeOneSqueeze)->Unit(benchmark::kMicrosecond);

} // namespace

} // namespace gripscope
