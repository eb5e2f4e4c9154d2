// SPDX-License-Identifier: GPL-3.0-or-later
// From the gripper to the verdict, one program after another: record, identify, enroll, classify, replay.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>

#include <cmath>
#include <csignal>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class SqueezeChainTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    ProgramRun record(const QString& object, int seed, const QString& file)
    {
        return m_work.cli({u"record"_s, u"--device"_s,
                           u"virtual:?object=%1&seed=%2&speed=0"_s.arg(object).arg(seed), u"--seconds"_s,
                           u"1"_s, u"--arm"_s, u"-o"_s, file, u"--json"_s});
    }
    static QByteArray rowsOf(const QString& path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {};
        QByteArray rows;
        for (const QByteArray& line : file.readAll().split('\n'))
            if (!line.startsWith('#'))
                rows += line + '\n';
        return rows;
    }

private slots:
    void fromTheGripperToTheVerdict()
    {
        const QList<QString> objects{u"A"_s, u"C"_s};
        for (const QString& object : objects) {
            QStringList files;
            for (int seed = 1; seed <= 5; ++seed) {
                const QString file = u"%1%2.csv"_s.arg(object).arg(seed);
                const ProgramRun run = record(object, seed, file);
                QCOMPARE(run.exit, 0);
                QCOMPARE(run.json()[u"lost_samples"].toInt(-1), 0);
                QVERIFY(run.json()[u"squeezed"].toBool());
                files << file;
            }
            const ProgramRun run = m_work.cli(
                QStringList{u"enroll"_s, u"--library"_s, u"lib.db"_s, u"--type"_s, object, u"--json"_s} +
                files);
            QCOMPARE(run.exit, 0);
            QCOMPARE(run.json()[u"type"].toString(), object);
            QCOMPARE(run.json()[u"squeezes"].toInt(), 5);
            QCOMPARE(run.json()[u"added"].toArray().size(), 5);
            QVERIFY(run.json()[u"rejected"].toArray().isEmpty());
            QVERIFY(run.err.contains("added " + files.last().toUtf8()));
        }
        QCOMPARE(record(u"A"_s, 101, u"part.csv"_s).exit, 0);
        QCOMPARE(record(u"0.060,60,12000"_s, 102, u"stranger.csv"_s).exit, 0);

        const ProgramRun known =
            m_work.cli({u"classify"_s, u"--library"_s, u"lib.db"_s, u"part.csv"_s, u"--json"_s});
        QCOMPARE(known.exit, 0);
        const QJsonObject result = known.json()[u"results"][0].toObject();
        QCOMPARE(result[u"file"].toString(), u"part.csv"_s);
        QCOMPARE(result[u"verdict"].toString(), u"type"_s);
        QCOMPARE(result[u"type"].toString(), u"A"_s);
        QCOMPARE(result[u"nearest"].toString(), u"A"_s);
        QVERIFY(result[u"posterior"][u"A"].toDouble() >= 0.999);
        QVERIFY(result[u"distance"].toDouble() <= result[u"gate"].toDouble());
        QCOMPARE(result[u"samples_used"].toInt(), 2000);
        QVERIFY(!result[u"reasons"].toArray().isEmpty());
        // Squared in the document, the roots in words.
        const ProgramRun words = m_work.cli({u"classify"_s, u"--library"_s, u"lib.db"_s, u"part.csv"_s});
        const auto root = [&result](const QString& member) {
            return QByteArray::number(std::sqrt(result[member].toDouble()), 'f', 1);
        };
        const QByteArray distance = root(u"distance"_s) + " sd away, gate " + root(u"gate"_s) + " sd";
        QVERIFY2(words.out.contains(distance), words.out.constData());

        const ProgramRun both = m_work.cli(
            {u"classify"_s, u"--library"_s, u"lib.db"_s, u"stranger.csv"_s, u"part.csv"_s, u"--json"_s});
        QCOMPARE(both.exit, 6);
        QCOMPARE(both.json()[u"results"][0][u"verdict"].toString(), u"unknown"_s);
        QVERIFY(both.json()[u"results"][0][u"type"].isNull());
        QCOMPARE(both.json()[u"results"][1][u"type"].toString(), u"A"_s);
    }
    void aRecordingSaysWhereItComesFrom()
    {
        QCOMPARE(record(u"B"_s, 7, u"b.csv"_s).exit, 0);
        QFile file(m_work.path(u"b.csv"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        for (const QByteArray fact :
             {"# serial: VG-7\n", "# address: virtual:?object=B&seed=7&speed=0\n", "# excitation: prbs\n",
              "# excitation_peak_N: 10\n", "# excitation_bias_N: 20\n", "# excitation_bit_s: 0.005\n",
              "# excitation_seed: 1\n", "# operator: tester\n",
              "# recorded_utc: ", "# firmware: ", "# device: ", "# force_unit: N\n", "# position_unit: m\n",
              "# force_hold: zoh\n", "time_s,force,position,sequence,status\n"})
            QVERIFY2(text.contains(fact), fact.constData());
        const ProgramRun run = m_work.cli({u"identify"_s, u"b.csv"_s, u"--json"_s});
        QCOMPARE(run.json()[u"recording"][u"samples"].toInt(), 2080); // 1 s, and 20 ms on either side
        QCOMPARE(run.json()[u"recording"][u"units"][u"m"].toString(), u"kg"_s);
        // can B: k = 10,500 N/m, with 4 % scatter between squeezes; five times that is never left
        QVERIFY(std::abs(run.json()[u"estimates"][1][u"parameters"][u"k"].toDouble() / 10500 - 1) < 0.2);
    }
    void aReplayGivesTheSameSamples()
    {
        QCOMPARE(record(u"A"_s, 11, u"first.csv"_s).exit, 0);
        const ProgramRun run = m_work.cli({u"record"_s, u"--device"_s, u"replay:first.csv"_s, u"--seconds"_s,
                                           u"5"_s, u"-o"_s, u"again.csv"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(!rowsOf(m_work.path(u"first.csv"_s)).isEmpty());
        QCOMPARE(rowsOf(m_work.path(u"again.csv"_s)), rowsOf(m_work.path(u"first.csv"_s)));
    }
    void withoutArmingNothingMoves()
    {
        const ProgramRun run = m_work.cli({u"record"_s, u"--device"_s, u"virtual:"_s, u"--seconds"_s,
                                           u"0.2"_s, u"-o"_s, u"rest.csv"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        QCOMPARE(run.json()[u"samples"].toInt(), 400);
        const QList<QByteArray> rows = rowsOf(m_work.path(u"rest.csv"_s)).trimmed().split('\n');
        for (qsizetype i = 1; i < rows.size(); ++i)
            QVERIFY(std::abs(rows[i].split(',')[1].toDouble()) < 1); // noise of the force sensor, no force
    }
    void whatTheDeviceDoesNotAllowIsExit4_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("word");
        QTest::newRow("too much force") << QStringList{u"--device"_s, u"virtual:?speed=0"_s, u"--peak"_s,
                                                       u"5000"_s,     u"--bias"_s,           u"6000"_s}
                                        << QByteArray("limit");
        QTest::newRow("unplugged") << QStringList{u"--device"_s, u"virtual:?speed=0&fault=unplug:0.5"_s}
                                   << QByteArray("went away");
        QTest::newRow("no such gripper")
            << QStringList{u"--device"_s, u"hid:1209:0001:no-such-serial"_s} << QByteArray("No gripper");
        QTest::newRow("a replay cannot squeeze")
            << QStringList{u"--device"_s, u"replay:part.csv"_s} << QByteArray("listens");
    }
    void whatTheDeviceDoesNotAllowIsExit4()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, word);
        if (!QFile::exists(m_work.path(u"part.csv"_s)))
            QCOMPARE(record(u"A"_s, 101, u"part.csv"_s).exit, 0);
        const ProgramRun run =
            m_work.cli(QStringList{u"record"_s, u"--arm"_s, u"-o"_s, u"never.csv"_s} + options);
        QCOMPARE(run.exit, 4);
        QVERIFY2(run.err.contains(word), run.err.constData());
        QVERIFY(!QFile::exists(m_work.path(u"never.csv"_s)));
    }
    void lostReportsStayGapsAndAreTold()
    {
        const ProgramRun run =
            m_work.cli({u"record"_s, u"--device"_s, u"virtual:?seed=5&speed=0&fault=loss:0.01"_s,
                        u"--seconds"_s, u"1"_s, u"--arm"_s, u"-o"_s, u"lossy.csv"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const int lost = run.json()[u"lost_samples"].toInt();
        QVERIFY(lost > 0);
        const QJsonObject document = m_work.cli({u"identify"_s, u"lossy.csv"_s, u"--json"_s}).json();
        bool told = false;
        for (const QJsonValue& check : document[u"validity"][u"checks"].toArray())
            told = told || (check[u"id"].toString() == u"samples_lost"_s && !check[u"ok"].toBool());
        QVERIFY(told);
    }
    void interruptingStopsTheGripperAndWritesNothing()
    {
        QProcess process;
        m_work.prepare(process, {u"record"_s, u"--device"_s, u"virtual:"_s, u"--seconds"_s, u"8"_s,
                                 u"--arm"_s, u"-o"_s, u"never.csv"_s});
        process.start();
        QVERIFY(process.waitForStarted());
        process.setReadChannel(QProcess::StandardError);
        while (!process.canReadLine())
            QVERIFY(process.waitForReadyRead(60'000)); // "Squeezing..."
        QElapsedTimer timer;
        timer.start();
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 4);
        QVERIFY(process.readAllStandardError().contains("cancelled"));
        QVERIFY(timer.elapsed() < 8000); // not after the whole squeeze
        QVERIFY(!QFile::exists(m_work.path(u"never.csv"_s)));
    }
    void whatCannotBeEnrolledIsRejectedWithItsReasonAndTheRestIsAdded()
    {
        QCOMPARE(record(u"D"_s, 1, u"d1.csv"_s).exit, 0);
        QCOMPARE(record(u"D"_s, 2, u"d2.csv"_s).exit, 0);
        QCOMPARE(record(u"D"_s, 3, u"d3.csv"_s).exit, 0);
        QByteArray constant =
            "# gripscope-recording: 1\n# sample_time_s: 0.001\n# force_unit: N\n# position_unit: m\n"
            "time_s,force,position\n";
        for (int i = 0; i < 500; ++i)
            constant += QByteArray::number(i * 0.001, 'g', 12) + ",20,0.002\n";
        m_work.write(u"constant.csv"_s, constant);
        const QStringList enroll{u"enroll"_s, u"--library"_s, u"reject.db"_s,
                                 u"--type"_s, u"D"_s,         u"--json"_s};
        const ProgramRun invalid =
            m_work.cli(enroll + QStringList{u"d1.csv"_s, u"constant.csv"_s, u"d2.csv"_s});
        QCOMPARE(invalid.exit, 6);
        QCOMPARE(invalid.json()[u"added"].toArray(), (QJsonArray{u"d1.csv"_s, u"d2.csv"_s}));
        QCOMPARE(invalid.json()[u"rejected"][0][u"file"].toString(), u"constant.csv"_s);
        QVERIFY(!invalid.json()[u"rejected"][0][u"reason"].toString().isEmpty());
        QCOMPARE(invalid.json()[u"squeezes"].toInt(), 2);

        const ProgramRun bad =
            m_work.cli(enroll + QStringList{u"missing.csv"_s, u"constant.csv"_s, u"d3.csv"_s});
        QCOMPARE(bad.exit, 3);
        QCOMPARE(bad.json()[u"squeezes"].toInt(), 3); // resumed
        // One that is in it already, under another name, and twice in one go.
        QVERIFY(QFile::copy(m_work.path(u"d2.csv"_s), m_work.path(u"copy.csv"_s)));
        QCOMPARE(record(u"D"_s, 4, u"d4.csv"_s).exit, 0);
        const ProgramRun copies = m_work.cli(enroll + QStringList{u"copy.csv"_s, u"d4.csv"_s, u"d4.csv"_s});
        QCOMPARE(copies.exit, 6);
        QCOMPARE(copies.json()[u"added"].toArray(), QJsonArray{u"d4.csv"_s});
        QCOMPARE(copies.json()[u"squeezes"].toInt(), 4);
        for (int i : {0, 1})
            QVERIFY(copies.json()[u"rejected"][i][u"reason"].toString().contains(u"has already"_s));
        // the other units: nothing to compare them with
        QVERIFY(m_work.cli({u"simulate"_s, u"--object"_s, u"1,1.2,1"_s, u"-o"_s, u"printed.csv"_s}).exit ==
                0);
        QCOMPARE(m_work.cli(enroll + QStringList{u"printed.csv"_s}).exit, 3);
        const ProgramRun classified =
            m_work.cli({u"classify"_s, u"--library"_s, u"reject.db"_s, u"printed.csv"_s, u"--json"_s});
        QCOMPARE(classified.exit, 3);
        QCOMPARE(classified.json()[u"results"][0][u"error"][u"code"].toString(), u"units_differ"_s);
    }
};

GRIPSCOPE_TEST(SqueezeChainTest)
#include "squeeze_chain_test.moc"
