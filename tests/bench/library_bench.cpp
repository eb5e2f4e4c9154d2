// SPDX-License-Identifier: GPL-3.0-or-later
// Opening a library: types, squeezes, models, counts; what the Inspect page needs before the first squeeze.
#include "core/session/squeeze/comparable_units.h"
#include "tests/core/library/raw_database.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// `types` types with `squeezes` squeezes each: the types by the library, the squeezes by SQLite itself,
/// which writes 100,000 in some seconds.
void fill(const QString& file, int types, int squeezes)
{
    {
        const auto library = Library::open(file);
        for (int type = 0; library && type < types; ++type)
            if (!(*library)->addType(u"type %1"_s.arg(type), {}, u"N"_s, u"m"_s))
                qFatal("a type could not be added");
    }
    test::RawDatabase database(file);
    const QString numbers =
        u"WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i + 1 < %1) "_s.arg(types *
                                                                                                   squeezes);
    const QString stamp = u"'s', '2026-01-01T00:00:00.000Z'"_s;
    const QString type = u"(i % %1)"_s.arg(types);
    // Factors as good as random, 3 % either side of 1.
    const auto scatter = [](int which) {
        return u"(0.97 + 0.06 * ((i * %1 + %2) % 1009) / 1009.0)"_s.arg(7919 + 104 * which).arg(331 * which);
    };
    database.run(u"BEGIN"_s);
    database.run(
        u"CREATE TEMP TABLE numbered AS SELECT id, ROW_NUMBER() OVER (ORDER BY name) - 1 AS place FROM types"_s);
    database.run(
        u"INSERT INTO grasps (id, station, recorded_utc, type_id, operator_name, source, force_unit, "
        "position_unit) "_s +
        numbers + u"SELECT printf('g%09d', i), "_s + stamp + u", (SELECT id FROM numbered WHERE place = "_s +
        type + u"), 'Ada', 'virtual:', 'N', 'm' FROM n"_s);
    database.run(
        u"INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, message, "
        "program, iterations, m, b, k, var_m, cov_mb, cov_mk, var_b, cov_bk, var_k, "
        "simulation_fit_percent) "_s +
        numbers + u"SELECT printf('e%09d', i), "_s + stamp +
        u", printf('g%09d', i), 0, 'oe', 'converged', '', '0.1', 9, "_s +
        u"0.02 * (1 + %1 / 20.0) * %2, 20 * (1 + %1 * 7 % 13) * %3, 3000 * (1 + %1 * 3 % 17) * %4, "_s.arg(
            type, scatter(1), scatter(2), scatter(3)) +
        u"1e-8, 0, 0, 0.01, 0, 100, 96.5 FROM n"_s);
    database.run(u"COMMIT"_s);
}

void openLibrary(benchmark::State& state)
{
    static int argc = 1;
    static char name[] = "bench";
    static char* argv[] = {name, nullptr};
    static const QCoreApplication application(argc, argv);
    const auto types = static_cast<int>(state.range(0));
    const auto squeezes = static_cast<int>(state.range(1));
    const QTemporaryDir folder;
    const QString file = folder.filePath(u"large.db"_s);
    fill(file, types, squeezes);
    for (auto _ : state) {
        const auto library = Library::open(file);
        const auto records = (*library)->types();
        const auto enrolled = (*library)->enrolledSqueezes();
        const auto counts = (*library)->inspectionCounts();
        if (!records || !counts || !enrolled ||
            enrolled->size() != std::size_t(types) * std::size_t(squeezes))
            qFatal("the library was not read");
        benchmark::DoNotOptimize(ComparableTypes(*records, *enrolled));
    }
}
BENCHMARK(openLibrary)->Args({4, 10})->Args({100, 1000})->Unit(benchmark::kMillisecond);

} // namespace
