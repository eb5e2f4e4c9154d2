// SPDX-License-Identifier: GPL-3.0-or-later
// From the bytes of stream reports to samples: CRC, fields, counters without wraps.
#include "devices/protocol/codec.h"
#include "devices/protocol/stream_assembler.h"

#include <benchmark/benchmark.h>

using namespace gripscope;
using namespace gripscope::protocol;

namespace {

void decodeStream(benchmark::State& state)
{
    const auto perReport = static_cast<std::uint8_t>(state.range(0));
    constexpr std::size_t count = 4096;
    std::vector<Report> reports(count);
    for (std::size_t i = 0; i < count; ++i) {
        StreamReport stream;
        stream.reportSequence = static_cast<std::uint32_t>(i);
        stream.firstSample = static_cast<std::uint32_t>(i * perReport);
        stream.timestamp_us = static_cast<std::uint32_t>(1000 * i);
        stream.count = perReport;
        for (std::size_t s = 0; s < perReport; ++s)
            stream.samples[s] = {static_cast<std::int32_t>(20000 + 7 * i),
                                 static_cast<std::int32_t>(600 + s)};
        reports[i] = encode(stream);
    }
    std::vector<Sample> samples;
    samples.reserve(count * perReport);
    for (auto _ : state) {
        StreamAssembler assembler(0.001, 2e-5, 0.0005);
        samples.clear();
        for (const Report& report : reports) {
            const Decoded<InputMessage> message = decodeInput(report);
            if (message)
                assembler.take(std::get<StreamReport>(*message), samples);
        }
        benchmark::DoNotOptimize(samples.data());
    }
    state.counters["samples/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(count * perReport),
                           benchmark::Counter::kIsRate);
}

BENCHMARK(decodeStream)->Arg(5)->Arg(2)->Unit(benchmark::kMicrosecond);

} // namespace
