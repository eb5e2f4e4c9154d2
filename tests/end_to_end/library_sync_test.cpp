// SPDX-License-Identifier: GPL-3.0-or-later
// A station's library, a file, brought in step with its plant's on a PostgreSQL server, by the program.
#include "core/library/library.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/plant_server.h"
#include "tests/support/test_registry.h"

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

void inspect(const QString& file, int inspections)
{
    const auto library = Library::open(file);
    QVERIFY(library);
    Recording recording;
    recording.sampleTime_s = 1e-3;
    for (int i = 0; i < 200; ++i) {
        recording.time_s.push_back(1e-3 * i);
        recording.force.push_back(std::sin(0.1 * i));
        recording.position.push_back(1e-3 * std::cos(0.07 * i));
    }
    Estimate estimate;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{2, 3, 40};
    for (int i = 0; i < inspections; ++i) {
        NewInspection inspection;
        inspection.grasp.recording = recording;
        inspection.grasp.estimates = {estimate};
        inspection.grasp.forceUnit = u"N"_s;
        inspection.grasp.positionUnit = u"m"_s;
        inspection.verdict.kind = VerdictKind::Unknown;
        inspection.expectedType = u"Can"_s;
        QVERIFY((*library)->addInspection(inspection));
    }
}

} // namespace

class LibrarySyncTest : public QObject {
    Q_OBJECT
private slots:
    void whatCannotBeSyncedIsSaid()
    {
        const Workplace work;
        const QString file = work.path(u"station.db"_s);
        inspect(file, 1);
        const QStringList sync{u"library"_s, u"sync"_s, u"--library"_s, file};
        QCOMPARE(work.cli(sync).exit, 2);
        QCOMPARE(work.cli(sync + QStringList{u"--server"_s, work.path(u"other.db"_s)}).exit, 2);
        const ProgramRun nobody = work.cli(
            sync + QStringList{u"--server"_s, u"postgresql://nobody@/plant?host="_s + work.path({})});
        QCOMPARE(nobody.exit, 5);
        QVERIFY2(nobody.err.contains("no server answers"), nobody.err.constData());
    }
    void nothingIsLostOrDoubledWhereBothAreKilledOnTheWay()
    {
        const Workplace work;
        const PlantServer server;
        const QString one = work.path(u"one.db"_s), other = work.path(u"other.db"_s);
        QCOMPARE(work.cli({u"simulate"_s, u"--object"_s, u"2,3,40"_s, u"-o"_s, u"a.csv"_s}).exit, 0);
        QCOMPARE(work.cli({u"enroll"_s, u"--library"_s, one, u"--type"_s, u"Can"_s, u"a.csv"_s}).exit, 0);
        constexpr int ofOne = 450, ofOther = 5; // several steps, and one
        inspect(one, ofOne);
        inspect(other, ofOther);
        const auto sync = [&](const QString& file) {
            return QStringList{u"library"_s,  u"sync"_s,        u"--library"_s, file,
                               u"--server"_s, server.address(), u"--json"_s};
        };
        for (int attempt = 0; attempt < 8; ++attempt) {
            QProcess program;
            work.prepare(program, sync(one));
            program.start();
            QVERIFY(program.waitForStarted());
            program.waitForFinished(60 * attempt); // somewhere on its way
            if (attempt % 2 == 0)
                program.kill();
            else
                server.crash();
            QVERIFY(program.waitForFinished(300'000));
        }
        for (const QString& file : {one, other, one})
            QCOMPARE(work.cli(sync(file)).exit, 0);
        const ProgramRun again = work.cli(sync(one));
        QCOMPARE(again.json()[u"rows"_s].toInt(-1), 0);
        const ProgramRun known =
            work.cli({u"library"_s, u"status"_s, u"--library"_s, server.address(), u"--json"_s});
        QCOMPARE(known.json()[u"stations"_s][0][u"inspections"_s].toInt(), ofOne + ofOther);
        for (const QString& place : {server.address(), one, other}) {
            const ProgramRun verified =
                work.cli({u"library"_s, u"verify"_s, u"--library"_s, place, u"--json"_s});
            QVERIFY2(verified.exit == 0, (verified.out + verified.err).constData());
        }
        const QByteArray types = work.cli({u"types"_s, u"list"_s, u"--library"_s, other, u"--json"_s}).out;
        QVERIFY2(types.contains("\"Can\""), types.constData());
    }
};

GRIPSCOPE_TEST(LibrarySyncTest)
#include "library_sync_test.moc"
