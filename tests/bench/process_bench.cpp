// SPDX-License-Identifier: GPL-3.0-or-later
// Control charts and capability of a type with a million inspections: what is read, what is drawn, and both
// as the Quality page has them, side by side in a pool. GRIPSCOPE_BENCH_INSPECTIONS: another number. The
// library is made by SQL, its recordings left out, which no chart reads; it takes a gigabyte and a half, and
// three minutes. GRIPSCOPE_BENCH_LIBRARY: the file to keep it in, which is taken as it is where it exists; or
// the address of a library on a server (ten_million.sh), of whose first type the charts are.
#include "core/library/library.h"
#include "core/library/records/history.h"
#include "core/library/sql/library_location.h"
#include "core/session/process/process_session.h"
#include "tests/core/library/many_inspections.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <thread>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const int inspections = qEnvironmentVariableIntValue("GRIPSCOPE_BENCH_INSPECTIONS") > 0
                            ? qEnvironmentVariableIntValue("GRIPSCOPE_BENCH_INSPECTIONS")
                            : 1'000'000;

const QString& benchFile()
{
    static int argc = 1;
    static char name[] = "bench";
    static char* argv[] = {name, nullptr};
    static const QCoreApplication application(argc, argv);
    static const QTemporaryDir folder;
    static const QString file = [] {
        const QString kept = qEnvironmentVariable("GRIPSCOPE_BENCH_LIBRARY");
        const QString path = kept.isEmpty() ? folder.filePath(u"process.db"_s) : kept;
        if (LibraryLocation::isOnServer(path) || QFile::exists(path))
            return path;
        if (!Library::open(path))
            qFatal("the library was not made");
        test::addManyInspections(path, inspections);
        // All of one type, m, b and k about a mean.
        test::RawDatabase raw(path);
        raw.run(u"UPDATE inspections SET verdict = 'type', type_name = 'A'"_s);
        raw.run(
            u"UPDATE estimates SET m = 0.04 + 1e-7 * (abs(random()) % 2001 + abs(random()) % 2001 - 2000), "
            "b = 43 + 1e-4 * (abs(random()) % 2001 + abs(random()) % 2001 - 2000), "
            "k = 9990 + 0.02 * (abs(random()) % 2001 + abs(random()) % 2001 - 2000)"_s);
        return path;
    }();
    return file;
}

Library& library()
{
    static const std::unique_ptr<Library> opened = std::move(*Library::open(benchFile()));
    return *opened;
}

const QString& type()
{
    static const QString first = library().historyChoices()->types.value(0);
    return first;
}

ProcessValues readAll(const ProcessQuery& query)
{
    ProcessValues values;
    ProcessPlace place;
    while (!place.through)
        place = *library().processStretch(query, place, values);
    return values;
}

const ProcessValues& values()
{
    static const ProcessValues read = readAll({.type = type()});
    return read;
}

ProcessOptions optionsOf(ProcessKind kind)
{
    ProcessOptions options;
    options.kind = kind;
    options.limits = {ToleranceLimits{0.0395, 0.0405}, ToleranceLimits{42.5, 43.5},
                      ToleranceLimits{9900, 10080}};
    return options;
}

void reading(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(readAll({.type = type()}));
}

/// Which takes the squeezes' own rows, too.
void readingOfAGripper(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(
            readAll({.type = type(), .gripper = library().historyChoices()->devices.value(1)}));
}

/// Of which there are fewest.
void readingOfARareType(benchmark::State& state)
{
    const QString rare = library().historyChoices()->types.back();
    for (auto _ : state)
        benchmark::DoNotOptimize(readAll({.type = rare}));
}

void oneStretch(benchmark::State& state)
{
    for (auto _ : state) {
        ProcessValues some;
        benchmark::DoNotOptimize(library().processStretch({.type = type()}, {}, some));
    }
}

void drawing(benchmark::State& state)
{
    const ProcessOptions options = optionsOf(ProcessKind(state.range(0)));
    const ProcessRows rows = processRows(values(), {});
    for (auto _ : state) {
        if (options.kind == ProcessKind::Hotelling)
            benchmark::DoNotOptimize(drawJoint(values(), rows, options));
        else
            benchmark::DoNotOptimize(drawQuantity(values(), rows, 2, options));
    }
}

void capability(benchmark::State& state)
{
    const ProcessRows rows = processRows(values(), {});
    for (auto _ : state)
        benchmark::DoNotOptimize(processCapability(values(), rows, 2, optionsOf(ProcessKind::Individuals)));
}

/// From the choice of a type until charts and capability of all three quantities are there.
void everything(benchmark::State& state)
{
    LibraryService service(benchFile());
    for (auto _ : state) {
        ProcessSession session(service);
        session.setOptions(optionsOf(ProcessKind(state.range(0))));
        session.setQuery({.type = type()});
        while (session.state() != ProcessSession::State::Shown) {
            session.poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (session.picture()->values->size() != values().size())
            qFatal("not all was read");
    }
}

/// One more inspection, charts and all.
void oneMore(benchmark::State& state)
{
    LibraryService service(benchFile());
    ProcessSession session(service);
    session.setOptions(optionsOf(ProcessKind::Individuals));
    session.setQuery({.type = type()});
    const auto wait = [&session] {
        while (session.state() != ProcessSession::State::Shown) {
            session.poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    };
    wait();
    for (auto _ : state) {
        session.refresh();
        wait();
    }
}

BENCHMARK(reading)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(readingOfAGripper)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(readingOfARareType)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(oneStretch)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(drawing)->DenseRange(0, 5)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(capability)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(everything)->Arg(0)->Arg(5)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(oneMore)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

} // namespace
