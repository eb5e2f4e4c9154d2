// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "devices/factory/gripper_factory.h"
#include "devices/replay/capture_folder.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QJsonArray>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

QByteArray contents(const QString& file)
{
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

} // namespace

class ReplayCommandTest : public QObject {
    Q_OBJECT
private slots:
    void aReplayWritesTheRecordingThatWasWrittenLive()
    {
        const Workplace place;
        const QString device = u"virtual:?speed=0&seed=3&fault=loss:0.02,crc:0.01&capture="_s;
        const ProgramRun live = place.cli({u"record"_s, u"--device"_s, device + place.path(u"s.gscap"_s),
                                           u"--seconds"_s, u"0.5"_s, u"--arm"_s, u"-o"_s, u"live.csv"_s});
        QVERIFY2(live.exit == 0, live.err.constData());
        const ProgramRun replay = place.cli({u"replay"_s, u"s.gscap"_s, u"--json"_s, u"-o"_s, u"again"_s});
        QVERIFY2(replay.exit == 0, replay.err.constData());
        const QJsonObject document = replay.json();
        QVERIFY(document[u"lost_samples"_s].toInt() > 0);
        QCOMPARE(document[u"dropped_records"_s].toInt(-1), 0);
        const QJsonArray squeezes = document[u"squeezes"_s].toArray();
        QCOMPARE(squeezes.size(), 1);
        const QJsonObject squeeze = squeezes.first().toObject();
        QVERIFY(squeeze[u"failure"_s].isNull());
        QCOMPARE(squeeze[u"file"_s].toString(), u"again/s-squeeze001.csv"_s);
        QVERIFY(!contents(place.path(u"live.csv"_s)).isEmpty());
        QCOMPARE(contents(place.path(u"again/s-squeeze001.csv"_s)), contents(place.path(u"live.csv"_s)));
    }

    void listeningIsCutOutAsItWas()
    {
        const Workplace place;
        const ProgramRun live = place.cli({u"record"_s, u"--device"_s,
                                           u"virtual:?fault=loss:0.05&capture="_s + place.path(u"s.gscap"_s),
                                           u"--seconds"_s, u"0.3"_s, u"-o"_s, u"live.csv"_s});
        QVERIFY2(live.exit == 0, live.err.constData());
        QCOMPARE(place.cli({u"replay"_s, u"s.gscap"_s, u"-o"_s, u"."_s}).exit, 0);
        QCOMPARE(contents(place.path(u"s-squeeze001.csv"_s)), contents(place.path(u"live.csv"_s)));
        const QString squeeze = u"s-squeeze001.csv"_s;
        QCOMPARE(place.cli({u"replay"_s, u"s.gscap"_s, u"-o"_s, u"."_s}).exit, 0); // again
        place.write(squeeze, "notes\n");
        const ProgramRun refused = place.cli({u"replay"_s, u"s.gscap"_s, u"-o"_s, u"."_s});
        QCOMPARE(refused.exit, 5);
        QVERIFY(refused.err.contains("--force"));
        QCOMPARE(place.cli({u"replay"_s, u"s.gscap"_s, u"--force"_s, u"-o"_s, u"."_s}).exit, 0);
    }

    void theVerdictsAreThoseOfTheRecordings()
    {
        const Workplace place;
        QStringList files;
        for (int i = 0; i < 5; ++i) {
            files << u"%1.csv"_s.arg(i);
            const QString capture = place.path(u"%1.gscap"_s.arg(i));
            QCOMPARE(place
                         .cli({u"record"_s, u"--device"_s,
                               u"virtual:?speed=0&seed=%1&capture=%2"_s.arg(i + 1).arg(capture),
                               u"--seconds"_s, u"0.5"_s, u"--arm"_s, u"-o"_s, files.back()})
                         .exit,
                     0);
        }
        const ProgramRun enrolled =
            place.cli(QStringList{u"enroll"_s, u"--library"_s, u"l.db"_s, u"--type"_s, u"A"_s, u"--json"_s} +
                      files.mid(0, 4));
        QCOMPARE(enrolled.exit, 0);
        QCOMPARE(enrolled.json()[u"approved"_s], QJsonValue(true)); // nobody is in this library
        const ProgramRun classified =
            place.cli({u"classify"_s, u"--library"_s, u"l.db"_s, u"--json"_s, files.back()});
        const ProgramRun replayed =
            place.cli({u"replay"_s, u"--library"_s, u"l.db"_s, u"--json"_s, u"4.gscap"_s});
        QCOMPARE(replayed.exit, classified.exit);
        QJsonObject expected = classified.json()[u"results"_s].toArray().first().toObject();
        QJsonObject found =
            replayed.json()[u"squeezes"_s].toArray().first().toObject()[u"verdict"_s].toObject();
        QVERIFY(expected.contains(u"distance"_s));
        expected.remove(u"file"_s);
        found.remove(u"file"_s);
        QCOMPARE(found, expected);
        // At rates that are given both say the same again, and something else than before.
        const QStringList rates{u"--false-reject"_s, u"0.05"_s, u"--stranger-accept"_s, u"0.002"_s};
        const QJsonObject given =
            place.cli(QStringList{u"replay"_s, u"--library"_s, u"l.db"_s, u"--json"_s, u"4.gscap"_s} + rates)
                .json()[u"squeezes"_s]
                .toArray()
                .first()
                .toObject();
        QCOMPARE(given[u"rates"_s][u"from"_s].toString(), u"given"_s);
        QCOMPARE(given[u"rates"_s][u"false_reject"_s].toDouble(), 0.05);
        QJsonObject foundAgain = given[u"verdict"_s].toObject();
        QJsonObject expectedAgain =
            place
                .cli(QStringList{u"classify"_s, u"--library"_s, u"l.db"_s, u"--json"_s, files.back()} + rates)
                .json()[u"results"_s]
                .toArray()
                .first()
                .toObject();
        foundAgain.remove(u"file"_s);
        expectedAgain.remove(u"file"_s);
        QCOMPARE(foundAgain, expectedAgain);
        QVERIFY(foundAgain[u"gate"_s].toDouble() < found[u"gate"_s].toDouble());
    }

    void whatIsNoCaptureIsSaidToBeNone()
    {
        const Workplace place;
        place.write(u"x.gscap"_s, "time_s,force,position\n");
        const ProgramRun run = place.cli({u"replay"_s, u"--json"_s, u"x.gscap"_s});
        QCOMPARE(run.exit, 3);
        QCOMPARE(run.json()[u"error"_s].toObject()[u"code"_s].toString(), u"bad_input"_s);
        QCOMPARE(place.cli({u"replay"_s}).exit, 2);
        QCOMPARE(place.cli({u"captures"_s, u"burn"_s}).exit, 2);
    }

    void keptSessionsAreListedVerifiedAndPruned()
    {
        const Workplace place;
        const QString path = place.path(u"kept"_s);
        for (int i = 0; i < 2; ++i) {
            DeviceFactory factory;
            factory.keepSessions(KeepSessions{path, {}, true});
            const auto port = factory.create(u"virtual:"_s).value();
            port->open();
            QTRY_VERIFY_WITH_TIMEOUT(port->counters().samples > 0, gripscope::test::longEnough_ms);
            port->close();
        }
        const CaptureFolder folder(path);
        QCOMPARE(folder.parts().size(), std::size_t(2));
        const QStringList common{u"--folder"_s, u"kept"_s, u"--json"_s};
        const QJsonArray listed =
            place.cli(QStringList{u"captures"_s, u"list"_s} + common).json()[u"captures"_s].toArray();
        QCOMPARE(listed.size(), 2);
        QVERIFY(listed.first().toObject()[u"closed"_s].toBool());
        QCOMPARE(place.cli(QStringList{u"captures"_s, u"verify"_s} + common).exit, 0);

        QFile second(folder.filePath(folder.parts().back().name));
        QVERIFY(second.open(QIODevice::Append));
        second.write("x");
        second.close();
        const ProgramRun verified = place.cli(QStringList{u"captures"_s, u"verify"_s} + common);
        QCOMPARE(verified.exit, 3);
        QCOMPARE(verified.json()[u"captures"_s].toArray().last().toObject()[u"condition"_s].toString(),
                 u"changed"_s);

        // A script is not asked; a library that is there is told.
        QVERIFY(Library::open(place.path(u"told.db"_s)));
        QCOMPARE(place
                     .cli(QStringList{u"captures"_s, u"prune"_s, u"--limit"_s, u"0"_s, u"--library"_s,
                                      u"told.db"_s, u"--reason"_s, u"the disk is small"_s} +
                          common)
                     .exit,
                 0);
        QVERIFY(folder.parts().empty());
        const QJsonArray entries =
            place.cli({u"audit"_s, u"--library"_s, u"told.db"_s, u"--json"_s}).json()[u"entries"_s].toArray();
        QCOMPARE(entries.size(), 1);
        QCOMPARE(entries[0].toObject()[u"action"_s].toString(), u"captures.pruned"_s);
        QCOMPARE(entries[0].toObject()[u"reason"_s].toString(), u"the disk is small"_s);
        // Nothing to remove is nothing to tell.
        QCOMPARE(
            place.cli(QStringList{u"captures"_s, u"prune"_s, u"--library"_s, u"told.db"_s} + common).exit, 0);
        QCOMPARE(place.cli({u"audit"_s, u"--library"_s, u"told.db"_s, u"--json"_s})
                     .json()[u"entries"_s]
                     .toArray()
                     .size(),
                 1);
    }
};

GRIPSCOPE_TEST(ReplayCommandTest)
#include "replay_command_test.moc"
