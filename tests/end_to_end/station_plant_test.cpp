// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/station_run.h"
#include "tests/support/plant_server.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

int inspectionsAt(const Workplace& work, const PlantServer& server)
{
    const ProgramRun known =
        work.cli({u"library"_s, u"status"_s, u"--library"_s, server.address(), u"--json"_s});
    return known.json()[u"stations"_s][0][u"inspections"_s].toInt();
}

} // namespace

/// gripscope-station and the library of its plant.
class StationPlantTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsInspectedIsAtTheServerThoughBothWereAwayMeanwhile()
    {
        const Workplace work;
        const PlantServer server;
        QCOMPARE(work.cli({u"library"_s, u"examples"_s, u"--library"_s, work.path(u"parts.db"_s)}).exit, 0);
        const QStringList toPlant{u"--plant"_s, server.address()};
        {
            StationRun station(work, toPlant);
            QVERIFY(station.arm());
            QVERIFY(station.inspect(4711));
            QTRY_COMPARE_WITH_TIMEOUT(inspectionsAt(work, server), 1, longEnough_ms);
            server.halt();
            QVERIFY(station.says(u"plant"_s, u"server not reached since"_s));
            QVERIFY(station.inspect(4712)); // it is not in the way
            QVERIFY(station.says(u"plant"_s, u"1 result waiting"_s));
            QVERIFY(station.ask(u"status"_s)
                        .json()[u"plantProblems"_s][0]
                        .toString()
                        .contains(u"no server answers"_s));
            station.kill();
        }
        {
            const StationRun station(work, toPlant); // which starts without the server
            QVERIFY(station.says(u"plant"_s, u"1 result waiting, server not reached since"_s));
            server.go();
            QVERIFY(station.says(u"plant"_s, u"plant: in step"_s));
        }
        QCOMPARE(inspectionsAt(work, server), 2);
        for (const QString& place : {server.address(), work.path(u"parts.db"_s)})
            QCOMPARE(work.cli({u"library"_s, u"verify"_s, u"--library"_s, place}).exit, 0);
    }
    void whatCannotBeIsSaidAtTheStart()
    {
        const Workplace work;
        const std::pair<QString, int> wrong[]{{u"other.db"_s, 2}, {u"postgresql://a:secret@host/plant"_s, 5}};
        for (const auto& [plant, exit] : wrong) {
            QProcess station;
            work.prepare(station, {u"--library"_s, work.path(u"parts.db"_s), u"--address"_s, u"virtual:"_s,
                                   u"--modbus"_s, u"127.0.0.1:%1"_s.arg(freePort()), u"--plant"_s, plant});
            station.setProgram(stationProgram());
            station.start();
            QVERIFY(station.waitForFinished(longEnough_ms));
            QCOMPARE(station.exitCode(), exit);
            const QByteArray said = station.readAllStandardError();
            QVERIFY2(said.contains("postgresql://"), said.constData());
            QVERIFY(!said.contains("secret"));
        }
    }
};

GRIPSCOPE_TEST(StationPlantTest)
#include "station_plant_test.moc"
