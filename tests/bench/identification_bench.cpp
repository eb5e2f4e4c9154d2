// SPDX-License-Identifier: GPL-3.0-or-later
// What an identification costs, and reading a file of the same length.
#include "core/identification/arx/arx.h"
#include "core/identification/identification.h"
#include "core/identification/model/discretization.h"
#include "core/identification/output_error/output_error.h"
#include "core/math/gaussian.h"
#include "core/research/truth_settings.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording_csv.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdlib>
#include <fstream>

using namespace gripscope;

namespace {

/// Can A in SI at 2 kHz with 10 um of position noise.
Recording squeeze(std::size_t samples)
{
    ExcitationOptions excitation;
    excitation.samples = samples;
    Recording recording;
    recording.sampleTime_s = excitation.sampleTime_s;
    recording.hold = ForceHold::Zero;
    recording.force = *makeExcitation(excitation);
    recording.position = simulate({0.0396, 43, 9990}, recording.force,
                                  {recording.sampleTime_s, ForceHold::Zero, 0, 0.001, 0, 0.01});
    GaussianNoise noise(1);
    for (double& y : recording.position)
        y += 1e-5 * noise();
    for (std::size_t i = 0; i < samples; ++i)
        recording.time_s.push_back(static_cast<double>(i) * recording.sampleTime_s);
    return recording;
}

void identifyEverything(benchmark::State& state)
{
    const Recording recording = squeeze(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(identify(recording));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// Parts that are not ideal, all models tried: a squeeze of each setting of `study truth` that has 2,000
/// samples.
void identifyRealPart(benchmark::State& state, const TruthSetting& setting)
{
    const Recording recording = drawSqueeze(setting, 1);
    for (auto _ : state)
        benchmark::DoNotOptimize(identify(recording));
}

[[maybe_unused]] const bool realPartsRegistered = [] {
    for (const TruthSetting& setting : truthSettings())
        if (std::lround(setting.seconds / setting.sampleTime_s) == 2000)
            benchmark::RegisterBenchmark(
                ("identifyRealPart/" + setting.name.toStdString()).c_str(),
                [setting](benchmark::State& state) { identifyRealPart(state, setting); })
                ->Unit(benchmark::kMillisecond);
    return true;
}();

void outputError(benchmark::State& state)
{
    const Recording recording = squeeze(static_cast<std::size_t>(state.range(0)));
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = ForceHold::Zero;
    for (auto _ : state)
        benchmark::DoNotOptimize(estimateOutputError(recording.force, recording.position, options));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// 5 % of the samples lost.
void outputErrorWithLosses(benchmark::State& state)
{
    const Recording recording = squeeze(static_cast<std::size_t>(state.range(0)));
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = ForceHold::Zero;
    for (std::size_t t = 7; t < recording.size(); t += 20)
        options.lost.push_back(t);
    for (auto _ : state)
        benchmark::DoNotOptimize(estimateOutputError(recording.force, recording.position, options));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void arx(benchmark::State& state)
{
    const Recording recording = squeeze(static_cast<std::size_t>(state.range(0)));
    ArxOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    for (auto _ : state)
        benchmark::DoNotOptimize(estimateArx(recording.force, recording.position, options));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// The least squares alone, without a constant, as the peers do it; run.sh has the record written for them.
void arxCoefficients(benchmark::State& state)
{
    const Recording recording = squeeze(static_cast<std::size_t>(state.range(0)));
    if (const char* const file = std::getenv("GRIPSCOPE_PEER_RECORD")) {
        std::ofstream out(file);
        out.precision(17);
        for (std::size_t i = 0; i < recording.size(); ++i)
            out << recording.force[i] << ',' << recording.position[i] << '\n';
    }
    ArxOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.freeOffset = false;
    for (auto _ : state)
        benchmark::DoNotOptimize(gripscope::arxCoefficients(recording.force, recording.position, options));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void readCsv(benchmark::State& state)
{
    const QByteArray text = toCsv(squeeze(static_cast<std::size_t>(state.range(0))));
    for (auto _ : state)
        benchmark::DoNotOptimize(parseRecordingCsv(text, QStringLiteral("squeeze.csv")));
    state.SetBytesProcessed(state.iterations() * text.size());
}

BENCHMARK(identifyEverything)->Arg(400)->Arg(2000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(outputError)->Arg(1000)->Arg(2000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(outputErrorWithLosses)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(arx)->Arg(400)->Arg(2000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(arxCoefficients)->Arg(2000)->Unit(benchmark::kMicrosecond);
BENCHMARK(readCsv)->Arg(2000)->Arg(1000000)->Unit(benchmark::kMillisecond);

} // namespace
