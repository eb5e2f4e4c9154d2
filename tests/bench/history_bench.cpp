// SPDX-License-Identifier: GPL-3.0-or-later
// What the History page asks of a library with 100,000 inspections, each on the library's thread; and storing
// one more with the counters behind it. GRIPSCOPE_BENCH_INSPECTIONS: another number; a million takes a
// gigabyte and a half, their recordings left out, which no list or chart reads. GRIPSCOPE_BENCH_LIBRARY: the
// address of a library on a server, which is taken as it is (ten_million.sh).
#include "core/library/library.h"
#include "core/library/records/history_list.h"
#include "tests/core/library/many_inspections.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const int fewInspections = qEnvironmentVariableIntValue("GRIPSCOPE_BENCH_INSPECTIONS") > 0
                               ? qEnvironmentVariableIntValue("GRIPSCOPE_BENCH_INSPECTIONS")
                               : 100'000;

/// One library for all; opened once.
Library& library()
{
    const QString onServer = qEnvironmentVariable("GRIPSCOPE_BENCH_LIBRARY");
    static int argc = 1;
    static char name[] = "bench";
    static char* argv[] = {name, nullptr};
    static const QCoreApplication application(argc, argv);
    static const QTemporaryDir folder;
    static const std::unique_ptr<Library> opened = [&onServer] {
        if (!onServer.isEmpty())
            return std::move(*Library::open(onServer));
        const QString file = folder.filePath(u"large.db"_s);
        if (!Library::open(file))
            qFatal("the library was not made");
        test::addManyInspections(file, fewInspections);
        return std::move(*Library::open(file));
    }();
    return *opened;
}

HistoryList listOf(const HistoryQuery& query)
{
    Expected<HistoryList> list = library().historyList(query);
    if (!list)
        qFatal("the history was not read");
    return std::move(*list);
}

HistoryList goneThrough(const HistoryQuery& query)
{
    HistoryList list = listOf(query);
    while (!list.through)
        list = *library().historyStretch(std::move(list));
    return list;
}

/// What is there when the page is shown: the first rows, and how many there are as far as that is known.
void list(benchmark::State& state, const HistoryQuery& query)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyPage(listOf(query), 0, 200));
}

void firstPage(benchmark::State& state)
{
    list(state, {});
}

void sorted(benchmark::State& state)
{
    HistoryQuery query;
    query.order = HistoryColumn(state.range(0));
    list(state, query);
}

/// What there is to choose from: of many_inspections.h or of fill_server.sql.
const HistoryChoices& chosen()
{
    static const HistoryChoices choices = *library().historyChoices();
    return choices;
}

std::vector<HistoryQuery> filters()
{
    const HistoryChoices& of = chosen();
    return {{.kind = SqueezeKind::Inspection},
            {.outcome = InspectionOutcome::Unknown},
            {.validity = ValidityVerdict::Suspect}, // none in a file: all rows are looked at
            {.type = of.types.back()},
            {.expected = of.expected.front()},
            {.operatorName = of.operators.front()},
            {.device = of.devices.value(1)},
            {.batch = of.batches.value(of.batches.size() / 2, u"none"_s)},
            {.from = QDateTime(QDate(2024, 2, 1), QTime(0, 0), Qt::UTC),
             .to = QDateTime(QDate(2024, 2, 8), QTime(0, 0), Qt::UTC)}};
}

void filtered(benchmark::State& state)
{
    list(state, filters()[std::size_t(state.range(0))]);
}

/// An operator (of many), a source (another one in each row of a file), a number, a part number, nothing.
void searched(benchmark::State& state)
{
    const QStringList texts{chosen().operators.back().toLower(), u"file 99990"_s, u"99990"_s, u"P000099990"_s,
                            u"no such text"_s};
    list(state, {.text = texts[state.range(0)]});
}

/// The longest that storing waits behind the counting of a filter.
void oneStretch(benchmark::State& state)
{
    const HistoryList begin = listOf(filters()[5]);
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyStretch(begin));
}

/// Until all that a filter finds is counted, while its first page is long there.
void counted(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(goneThrough(filters()[std::size_t(state.range(0))]));
}

/// For a report.
void inForce(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyInForce({}));
}

void jumpToTheMiddle(benchmark::State& state)
{
    const HistoryList list = listOf({});
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyPage(list, list.rows / 2, 200));
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

/// All of them, and those of an operator once they are counted.
void points(benchmark::State& state)
{
    const HistoryList list = goneThrough(state.range(0) == 0 ? HistoryQuery{} : filters()[5]);
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyPoints(list));
}

NewInspection anInspection()
{
    NewInspection inspection;
    Recording recording;
    recording.sampleTime_s = 0.0005;
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"m"_s;
    for (int i = 0; i < 2000; ++i) {
        recording.time_s.push_back(0.0005 * i);
        recording.force.push_back(20 + 10 * (i / 10 % 2));
        recording.position.push_back(1e-6 * (2000 + i * i % 97));
    }
    inspection.grasp.recording = recording;
    inspection.grasp.forceUnit = recording.forceUnit;
    inspection.grasp.positionUnit = recording.positionUnit;
    inspection.verdict.kind = VerdictKind::Unknown;
    return inspection;
}

/// The first inspection after so many from elsewhere counts them all, once.
void storeAndCount(benchmark::State& state)
{
    const auto store = [] {
        if (!library().addInspection(anInspection()) || !library().inspectionCounts())
            qFatal("an inspection was not stored");
    };
    store();
    for (auto _ : state)
        store();
}

/// The counters of a shift: the inspections behind a number.
void countSinceANumber(benchmark::State& state)
{
    const qint64 last = library().historyCounts({})->inspections;
    for (auto _ : state)
        benchmark::DoNotOptimize(library().inspectionCounts(last - 400));
}

BENCHMARK(storeAndCount)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(countSinceANumber)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(firstPage)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sorted)
    ->DenseRange(0, int(HistoryColumn::Conformity))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(filtered)->DenseRange(0, 8)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(searched)->DenseRange(0, 4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(oneStretch)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(counted)->Arg(5)->Arg(8)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(inForce)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(jumpToTheMiddle)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(counts)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(choices)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(points)->DenseRange(0, 1)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
