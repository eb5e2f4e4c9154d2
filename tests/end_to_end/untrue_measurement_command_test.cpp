// SPDX-License-Identifier: GPL-3.0-or-later
// A gripper that measures wrongly, as the command line tells it: record, identify, classify.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class UntrueMeasurementCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    ProgramRun record(const QString& device, const QString& file)
    {
        return m_work.cli({u"record"_s, u"--device"_s, device, u"--seconds"_s, u"1"_s, u"--arm"_s, u"-o"_s,
                           file, u"--json"_s});
    }

private slots:
    void initTestCase()
    {
        // Three types, so that there is something to classify as.
        for (const QString& type : {u"A"_s, u"B"_s, u"C"_s}) {
            QStringList files;
            for (int seed = 1; seed <= 5; ++seed) {
                files << u"%1%2.csv"_s.arg(type).arg(seed);
                const ProgramRun run =
                    record(u"virtual:?object=%1&seed=%2&speed=0"_s.arg(type).arg(seed), files.back());
                QVERIFY2(run.exit == 0, run.err.constData());
            }
            const ProgramRun enrolled = m_work.cli(
                QStringList{u"enroll"_s, u"--library"_s, u"types.db"_s, u"--type"_s, type} + files);
            QVERIFY2(enrolled.exit == 0, enrolled.err.constData());
        }
    }
    void isRefusedByChoiceOnly_data()
    {
        QTest::addColumn<QStringList>("policy");
        QTest::addColumn<bool>("refused");
        QTest::newRow("no policy") << QStringList() << false;
        QTest::newRow("more allowed") << QStringList{u"--most-lost"_s, u"0.2"_s} << false;
        QTest::newRow("less allowed") << QStringList{u"--most-lost"_s, u"0.001"_s} << true;
        QTest::newRow("calibration overdue") << QStringList{u"--refuse-overdue"_s} << true;
    }
    void isRefusedByChoiceOnly()
    {
        QFETCH(QStringList, policy);
        QFETCH(bool, refused);
        const ProgramRun made = record(u"virtual:?object=A&seed=21&speed=0&fault=loss:0.02"_s, u"lost.csv"_s);
        QVERIFY2(made.exit == 0, made.err.constData());
        QFile file(m_work.path(u"lost.csv"_s));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray measured = file.readAll();
        measured.insert(measured.indexOf('\n') + 1, "# force_calibration_days_left: -12\n");
        file.seek(0);
        file.write(measured);
        file.close();
        const ProgramRun run = m_work.cli(
            QStringList{u"classify"_s, u"--library"_s, u"types.db"_s, u"--json"_s, u"lost.csv"_s} + policy);
        QCOMPARE(run.exit, refused ? 6 : 0);
        const QJsonObject result = run.json()[u"results"].toArray().first().toObject();
        QCOMPARE(result[u"refused"].toBool(), refused);
        QCOMPARE(result[u"verdict"].toString(), refused ? u"invalid"_s : u"type"_s);
        QCOMPARE(result[u"validity"].toString(), u"suspect"_s); // what it is worth stays as it is
        const QString reasons = QString::fromUtf8(run.out);
        QCOMPARE(reasons.contains(u"Not judged"_s), refused);
    }
    void isToldByName_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<QString>("validity");
        QTest::addColumn<QString>("failed");
        QTest::newRow("nothing") << QString() << u"valid"_s << QString();
        QTest::newRow("2 % lost") << u"&fault=loss:0.02"_s << u"suspect"_s << u"samples_lost"_s;
        QTest::newRow("clipped") << u"&fault=saturate:25"_s << u"invalid"_s << u"saturation"_s;
        QTest::newRow("stuck") << u"&fault=stuck"_s << u"invalid"_s << u"stuck"_s;
    }
    void isToldByName()
    {
        QFETCH(QString, fault);
        QFETCH(QString, validity);
        QFETCH(QString, failed);
        const ProgramRun made = record(u"virtual:?object=A&seed=21&speed=0"_s + fault, u"part.csv"_s);
        QVERIFY2(made.exit == 0, made.err.constData());
        const bool invalid = validity == u"invalid"_s;
        const ProgramRun run =
            m_work.cli({u"classify"_s, u"--library"_s, u"types.db"_s, u"--json"_s, u"part.csv"_s});
        QCOMPARE(run.exit, invalid ? 6 : 0);
        const QJsonObject result = run.json()[u"results"].toArray().first().toObject();
        QCOMPARE(result[u"validity"].toString(), validity);
        QCOMPARE(result[u"verdict"].toString(), invalid ? u"invalid"_s : u"type"_s);
        QCOMPARE(result[u"type"].toString(), invalid ? QString() : u"A"_s);
        const QJsonArray checks = result[u"checks_failed"].toArray();
        QCOMPARE(checks.isEmpty(), failed.isEmpty());
        QVERIFY(failed.isEmpty() || checks.contains(failed));
        QVERIFY(!result[u"reasons"].toArray().isEmpty());
        const QByteArray text = m_work.cli({u"classify"_s, u"--library"_s, u"types.db"_s, u"part.csv"_s}).out;
        QCOMPARE(text.contains("suspect"), validity == u"suspect"_s);
        // The document of the squeeze says the same, with a number and a limit.
        const QJsonObject document = m_work.cli({u"identify"_s, u"part.csv"_s, u"--json"_s}).json();
        QCOMPARE(document[u"validity"][u"verdict"].toString(), validity);
        for (const QJsonValue& check : document[u"validity"][u"checks"].toArray()) {
            if (check[u"id"].toString() != failed)
                continue;
            QVERIFY(!check[u"ok"].toBool() && check[u"value"].isDouble() && check[u"limit"].isDouble());
            QVERIFY(!check[u"message"].toString().contains(u'_'));
        }
    }
    void anOverdueCalibrationIsTold()
    {
        QVERIFY(record(u"virtual:?object=A&seed=22&speed=0"_s, u"part.csv"_s).exit == 0);
        QFile file(m_work.path(u"part.csv"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray text = file.readAll();
        text.replace("# gripscope-recording: 1\n",
                     "# gripscope-recording: 1\n# force_calibration: on 2019-01-01\n"
                     "# force_calibration_days_left: -2151\n");
        m_work.write(u"overdue.csv"_s, text);
        const ProgramRun run =
            m_work.cli({u"classify"_s, u"--library"_s, u"types.db"_s, u"--json"_s, u"overdue.csv"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject result = run.json()[u"results"].toArray().first().toObject();
        QCOMPARE(result[u"validity"].toString(), u"suspect"_s);
        QCOMPARE(result[u"checks_failed"].toArray(), QJsonArray{u"calibration"_s});
        QVERIFY(result[u"reasons"].toArray().last().toString().contains(u"overdue by 2151 days"_s));
    }
};

GRIPSCOPE_TEST(UntrueMeasurementCommandTest)
#include "untrue_measurement_command_test.moc"
