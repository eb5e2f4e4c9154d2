// SPDX-License-Identifier: GPL-3.0-or-later
// Storing inspections one by one, and verifying a library of them: rows, chain, signatures, file. They are
// what a session stores of the default recipe: 2,000 samples in whole counts, and all that was identified.
//   GRIPSCOPE_BENCH_FOLDER: where the libraries are made; in memory (/dev/shm) the disk is left out
//   GRIPSCOPE_BENCH_INSPECTIONS: one more size, such as 100000
#include "core/identification/identification.h"
#include "core/identification/model/discretization.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/library.h"
#include "core/library/verification/library_verification.h"
#include "core/session/enroll/enrollment_storage.h"
#include "core/signal/excitation/excitation.h"

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

/// A squeeze of the default recipe, in whole counts, with noise of its own.
Recording squeezed(std::mt19937& random)
{
    static const auto truth = [] {
        ExcitationOptions excitation;
        excitation.samples = 2000;
        Recording recording;
        recording.sampleTime_s = excitation.sampleTime_s;
        recording.hold = ForceHold::Zero;
        recording.forceUnit = u"N"_s;
        recording.positionUnit = u"m"_s;
        recording.force = *makeExcitation(excitation);
        SimulationOptions options;
        options.sampleTime_s = recording.sampleTime_s;
        options.x0 = recording.force.front() / 9990;
        recording.position = simulate({0.0396, 43, 9990}, recording.force, options);
        for (std::size_t i = 0; i < recording.force.size(); ++i) {
            recording.time_s.push_back(double(i) * recording.sampleTime_s);
            recording.sequence.push_back(i);
            recording.status.push_back(3);
        }
        return recording;
    }();
    std::normal_distribution<double> noise(0, 2);
    Recording recording = truth;
    for (std::size_t i = 0; i < recording.force.size(); ++i) {
        recording.force[i] = 0.001 * std::round(recording.force[i] / 0.001 + noise(random));
        recording.position[i] = 1e-7 * std::round(recording.position[i] / 1e-7 + noise(random));
    }
    return recording;
}

/// As a session stores it, with all that was identified once.
NewInspection inspected(std::mt19937& random)
{
    static const NewGrasp grasp = [&random] {
        const Recording recording = squeezed(random);
        return makeGrasp(recording, identify(recording), u"bench"_s, u"Ada"_s);
    }();
    NewInspection inspection;
    inspection.grasp = grasp;
    inspection.grasp.recording = squeezed(random);
    inspection.verdict.kind = VerdictKind::Type;
    inspection.verdict.type = inspection.verdict.nearest = u"A"_s;
    inspection.verdict.posterior = {{u"A"_s, 0.9993}, {u"B"_s, 0.0004}, {u"C"_s, 0.0003}};
    inspection.verdict.distance = 2.1;
    inspection.verdict.gate = 16.3;
    inspection.expectedType = u"A"_s;
    inspection.seconds = 1;
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
