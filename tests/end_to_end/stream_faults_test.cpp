// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong on the wire, from the virtual gripper to the recording and the verdict of the measurement.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class StreamFaultsTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    static QJsonObject samplesLost(const QJsonObject& document)
    {
        for (const QJsonValue& check : document[u"validity"][u"checks"].toArray())
            if (check[u"id"].toString() == u"samples_lost"_s)
                return check.toObject();
        return {};
    }

private slots:
    void isCountedKeptAndJudged_data()
    {
        QTest::addColumn<QString>("options"); ///< of the virtual gripper
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QString>("counted"); ///< in the recording's account
        QTest::addColumn<QString>("word");    ///< of the check; empty: it passes
        const QString fast = u"speed=0&"_s;
        QTest::newRow("nothing") << fast << QByteArray() << QString() << QString();
        QTest::newRow("loss") << fast + u"fault=loss:0.01&"_s << QByteArray() << u"gaps"_s << u"missing"_s;
        QTest::newRow("damaged") << fast + u"fault=crc:0.01&"_s << QByteArray() << u"bad_reports"_s
                                 << u"missing"_s;
        QTest::newRow("duplicates") << fast + u"fault=duplicate:0.05&"_s << QByteArray()
                                    << u"duplicate_reports"_s << QString();
        // At speed 0 time passes in squeezes only, so that a script's times lie within this one.
        QTest::newRow("clock set forward")
            << fast << QByteArray("0.5 clock +0.3\n") << u"clock_steps"_s << u"clock jumped"_s;
        QTest::newRow("clock set back")
            << fast << QByteArray("0.5 clock -0.2\n") << u"clock_steps"_s << u"clock jumped"_s;
        // Listened to; in a squeeze it is stopped, see below.
        QTest::newRow("stall") << QString() << QByteArray("2.0 stall\n2.3 resume\n") << u"stalls"_s
                               << u"fell silent"_s;
    }
    void isCountedKeptAndJudged()
    {
        QFETCH(QString, options);
        QFETCH(QByteArray, script);
        QFETCH(QString, counted);
        QFETCH(QString, word);
        m_work.write(u"faults.txt"_s, script);
        const QString device = u"virtual:?seed=3&"_s + options + u"script="_s + m_work.path(u"faults.txt"_s);
        const QString seconds = options.isEmpty() ? u"4"_s : u"1"_s;
        QStringList arguments{u"record"_s, u"--device"_s, device,           u"--seconds"_s,
                              seconds,     u"-o"_s,       u"squeeze.csv"_s, u"--json"_s};
        if (!options.isEmpty())
            arguments << u"--arm"_s;
        const ProgramRun run = m_work.cli(arguments);
        QVERIFY2(run.exit == 0, run.err.constData());
        const QJsonObject stream = run.json()[u"stream"].toObject();
        for (const QString& name :
             {u"gaps"_s, u"duplicate_reports"_s, u"bad_reports"_s, u"clock_steps"_s, u"stalls"_s}) {
            const bool follows = name == u"gaps"_s && (counted == u"bad_reports"_s || counted == u"stalls"_s);
            if (!follows)
                QVERIFY2((stream[name].toInt(-1) > 0) == (name == counted), qPrintable(name));
        }
        QFile file(m_work.path(u"squeeze.csv"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\n# stream: lost_samples="));
        const QJsonObject document = m_work.cli({u"identify"_s, u"squeeze.csv"_s, u"--json"_s}).json();
        const QJsonObject check = samplesLost(document);
        QCOMPARE(check[u"ok"].toBool(), word.isEmpty());
        QVERIFY2(check[u"message"].toString().contains(word), qPrintable(check[u"message"].toString()));
        QCOMPARE(document[u"validity"][u"verdict"].toString() == u"valid"_s, word.isEmpty());
    }

    void aStallInASqueezeStopsItWithWords_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QByteArray>("told");
        // Opening, arming and uploading take less than four seconds, the squeeze eight.
        QTest::newRow("it is heard again in time")
            << QByteArray("4.0 stall\n4.1 resume\n") << QByteArray("no samples came for 50 ms");
        // Nobody saw that it stopped.
        QTest::newRow("it stays silent") << QByteArray("4.0 stall\n4.5 resume\n")
                                         << QByteArray("did not obey Stop. Switch off its power.");
    }
    void aStallInASqueezeStopsItWithWords()
    {
        QFETCH(QByteArray, script);
        QFETCH(QByteArray, told);
        m_work.write(u"silence.txt"_s, script);
        const ProgramRun run =
            m_work.cli({u"record"_s, u"--device"_s, u"virtual:?script="_s + m_work.path(u"silence.txt"_s),
                        u"--seconds"_s, u"8"_s, u"--arm"_s, u"-o"_s, u"silence.csv"_s});
        QCOMPARE(run.exit, 4);
        QVERIFY2(run.err.contains(told), run.err.constData());
        QVERIFY(!QFile::exists(m_work.path(u"silence.csv"_s)));
    }
};

GRIPSCOPE_TEST(StreamFaultsTest)
#include "stream_faults_test.moc"
