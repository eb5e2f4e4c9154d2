// SPDX-License-Identifier: GPL-3.0-or-later
// What the History page asks of a library with 100,000 inspections, each on the library's thread; and storing
// one more with the counters behind it. GRIPSCOPE_BENCH_INSPECTIONS: another number; a million takes a
// gigabyte and a half, their recordings left out, which no list or chart reads.
#include "core/library/library.h"
#include "core/library/records/history_list.h"
#include "tests/core/library/many_inspections.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const int inspections = qEnvironmentVariableIntValue("GRIPSCOPE_BENCH_INSPECTIONS") > 0
                            ? qEnvironmentVariableIntValue("GRIPSCOPE_BENCH_INSPECTIONS")
                            : 100'000;

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

std::vector<HistoryQuery> filters()
{
    return {{.kind = SqueezeKind::Inspection},
            {.outcome = InspectionOutcome::Unknown},
            {.validity = ValidityVerdict::Suspect}, // none: all rows are looked at
            {.type = u"B"_s},
            {.expected = u"A"_s},
            {.operatorName = u"Ada"_s},
            {.device = u"Gripper 0001"_s},
            {.from = QDateTime(QDate(2024, 2, 1), QTime(0, 0), Qt::UTC),
             .to = QDateTime(QDate(2024, 2, 8), QTime(0, 0), Qt::UTC)}};
}

void filtered(benchmark::State& state)
{
    list(state, filters()[std::size_t(state.range(0))]);
}

/// An operator (half of all), a source (another one in each row), a number, nothing.
void searched(benchmark::State& state)
{
    const QStringList texts{u"bob"_s, u"file 99990"_s, u"99990"_s, u"no such text"_s};
    list(state, {.text = texts[state.range(0)]});
}

/// The longest that storing waits behind the counting of a filter.
void oneStretch(benchmark::State& state)
{
    const HistoryList begin = listOf({.operatorName = u"Ada"_s});
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyStretch(begin));
}

void jumpToTheMiddle(benchmark::State& state)
{
    const HistoryList list = listOf({});
    for (auto _ : state)
        benchmark::DoNotOptimize(library().historyPage(list, inspections / 2, 200));
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
    const HistoryQuery query{.operatorName = state.range(0) == 0 ? u""_s : u"Ada"_s};
    const HistoryList list = goneThrough(query);
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
    for (auto _ : state)
        benchmark::DoNotOptimize(library().inspectionCounts(inspections - 400));
}

BENCHMARK(storeAndCount)->Unit(benchmark::kMillisecond);
BENCHMARK(countSinceANumber)->Unit(benchmark::kMillisecond);
BENCHMARK(firstPage)->Unit(benchmark::kMillisecond);
BENCHMARK(sorted)->DenseRange(0, int(HistoryColumn::Conformity))->Unit(benchmark::kMillisecond);
BENCHMARK(filtered)->DenseRange(0, 7)->Unit(benchmark::kMillisecond);
BENCHMARK(searched)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(oneStretch)->Unit(benchmark::kMillisecond);
BENCHMARK(jumpToTheMiddle)->Unit(benchmark::kMillisecond);
BENCHMARK(counts)->Unit(benchmark::kMillisecond);
BENCHMARK(choices)->Unit(benchmark::kMillisecond);
BENCHMARK(points)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

} // namespace
