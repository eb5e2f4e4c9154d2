// SPDX-License-Identifier: GPL-3.0-or-later
// What the History page asks of a library with 100,000 inspections, each on the library's thread.
#include "core/library/library.h"
#include "core/library/records/history.h"
#include "tests/core/library/many_inspections.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

constexpr int inspections = 100'000;

/// One library for all; opened once.
Library& library()
{
    static int argc = 1;
    static char name[] = "bench";
    static char* argv[] = {name, nullptr};
    static const QCoreApplication application(argc, argv);
    static const QTemporaryDir folder;
    static const std::unique_ptr<Library> opened = [] {
        const QString file = folder.filePath(u"large.db"_s);
        if (!Library::open(file))
            qFatal("the library was not made");
        test::addManyInspections(file, inspections);
        return std::move(*Library::open(file));
    }();
    return *opened;
}

void list(benchmark::State& state, const HistoryQuery& query)
{
    for (auto _ : state) {
        const auto keys = library().historyKeys(query);
        if (!keys)
            qFatal("the history was not read");
        benchmark::DoNotOptimize(library().historyEntries(keys->part(0, 200)));
    }
}

void sorted(benchmark::State& state)
{
    HistoryQuery query;
    query.order = HistoryColumn(state.range(0));
    list(state, query);
}

void filtered(benchmark::State& state)
{
    const std::vector<HistoryQuery> filters{{.text = u"bob"_s},
                                            {.kind = SqueezeKind::Inspection},
                                            {.outcome = InspectionOutcome::Unknown},
                                            {.type = u"B"_s},
                                            {.expected = u"A"_s},
                                            {.operatorName = u"Ada"_s},
                                            {.device = u"Gripper 0001"_s},
                                            {.from = QDateTime(QDate(2024, 2, 1), QTime(0, 0), Qt::UTC),
                                             .to = QDateTime(QDate(2024, 2, 8), QTime(0, 0), Qt::UTC)}};
    list(state, filters[std::size_t(state.range(0))]);
}

void jumpToTheMiddle(benchmark::State& state)
{
    const auto keys = library().historyKeys({});
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyEntries(keys->part(inspections / 2, 200)));
}

void counts(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyCounts({}));
}

void choices(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyChoices());
}

void points(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyPoints({}));
}

BENCHMARK(sorted)->DenseRange(0, int(HistoryColumn::Program))->Unit(benchmark::kMillisecond);
BENCHMARK(filtered)->DenseRange(0, 7)->Unit(benchmark::kMillisecond);
BENCHMARK(jumpToTheMiddle)->Unit(benchmark::kMillisecond);
BENCHMARK(counts)->Unit(benchmark::kMillisecond);
BENCHMARK(choices)->Unit(benchmark::kMillisecond);
BENCHMARK(points)->Unit(benchmark::kMillisecond);

} // namespace
