// SPDX-License-Identifier: GPL-3.0-or-later
// Storing inspections one by one, and verifying a library of them: rows, chain, signatures, file. Recordings
// are of 2,000 samples in whole counts, as a gripper sends them.
//   GRIPSCOPE_BENCH_FOLDER: where the libraries are made; in memory (/dev/shm) the disk is left out
//   GRIPSCOPE_BENCH_INSPECTIONS: one more size, such as 100000
#include "core/library/ledger/library_witness.h"
#include "core/library/library.h"
#include "core/library/verification/library_verification.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>
#include <cmath>
#include <random>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

void startQt()
{
    static int argc = 1;
    static char name[] = "bench";
    static char* argv[] = {name, nullptr};
    static const QCoreApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
}

Recording squeezed(std::mt19937& random)
{
    std::normal_distribution<double> noise(0, 2);
    Recording recording;
    recording.sampleTime_s = 0.0005;
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"m"_s;
    double force = 15, position = 0;
    for (int i = 0; i < 2000; ++i) {
        if (i % 40 == 0)
            force = random() % 2 ? 18 : 12;
        position += 0.05 * (force / 10000 - position);
        recording.time_s.push_back(i * recording.sampleTime_s);
        recording.force.push_back(0.001 * std::round(force / 0.001 + noise(random)));
        recording.position.push_back(1e-7 * std::round(position / 1e-7 + noise(random)));
        recording.sequence.push_back(std::uint64_t(i));
        recording.status.push_back(3);
    }
    return recording;
}

NewInspection inspected(std::mt19937& random)
{
    NewInspection inspection;
    inspection.grasp.recording = squeezed(random);
    inspection.grasp.forceUnit = u"N"_s;
    inspection.grasp.positionUnit = u"m"_s;
    Estimate estimate;
    estimate.estimator = Estimator::OutputError;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{0.04, 43, 9990};
    inspection.grasp.estimates = {estimate};
    inspection.grasp.identification = {{u"recommended"_s, u"oe"_s}};
    inspection.verdict.kind = VerdictKind::Type;
    inspection.verdict.type = inspection.verdict.nearest = u"A"_s;
    return inspection;
}

/// A library of `count` inspections, made once for each count.
QString libraryOf(std::int64_t count)
{
    static const QString place = qEnvironmentVariable("GRIPSCOPE_BENCH_FOLDER", QDir::tempPath());
    static const QTemporaryDir folder(place + u"/verification-XXXXXX"_s);
    const QString file = folder.filePath(u"of%1.db"_s.arg(count));
    if (QFileInfo::exists(file))
        return file;
    std::mt19937 random(1);
    const auto library = Library::open(file);
    for (std::int64_t i = 0; i < count; ++i)
        if (!library || !(*library)->addInspection(inspected(random)))
            qFatal("an inspection could not be stored");
    return file;
}

void verify(benchmark::State& state)
{
    startQt();
    const QString file = libraryOf(state.range(0));
    qint64 rows = 0;
    for (auto _ : state) {
        const auto found = verifyLibrary(file);
        if (!found || !found->whole())
            qFatal("the library is not whole");
        rows = found->rows;
    }
    state.counters["rows"] = double(rows);
    state.counters["kB_an_inspection"] = double(QFileInfo(file).size()) / double(state.range(0)) / 1000;
    QFile::remove(witnessFile(file));
}
void sizes(benchmark::internal::Benchmark* bench)
{
    bench->Arg(1000)->Arg(4000);
    if (const int more = qEnvironmentVariableIntValue("GRIPSCOPE_BENCH_INSPECTIONS"); more > 0)
        bench->Arg(more);
}
BENCHMARK(verify)->Apply(sizes)->Unit(benchmark::kMillisecond);

void store(benchmark::State& state)
{
    startQt();
    const QString file = libraryOf(state.range(0));
    const auto library = Library::open(file);
    std::mt19937 random(2);
    for (auto _ : state) {
        state.PauseTiming();
        const NewInspection inspection = inspected(random);
        state.ResumeTiming();
        if (!library || !(*library)->addInspection(inspection))
            qFatal("an inspection could not be stored");
    }
}
BENCHMARK(store)->Apply(sizes)->Unit(benchmark::kMillisecond);

} // namespace
