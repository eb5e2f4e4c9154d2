// SPDX-License-Identifier: GPL-3.0-or-later
// What the library knows of a gripper's channels reaches its recordings, and files tell the hold together.
#include "core/calibration/sensor_calibration.h"
#include "core/library/library.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <algorithm>
#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class MeasuringChainCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    ProgramRun record(const QString& file, const QStringList& more = {})
    {
        return m_work.cli(QStringList{u"record"_s, u"--device"_s, u"virtual:?object=A&seed=1&speed=0"_s,
                                      u"--seconds"_s, u"0.3"_s, u"--arm"_s, u"-o"_s, file} +
                          more);
    }
    QByteArray textOf(const QString& file)
    {
        QFile input(m_work.path(file));
        return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
    }

private slots:
    void initTestCase()
    {
        QCOMPARE(record(u"before.csv"_s).exit, 0); // nothing is known yet
        NewMeasuringChain measured;
        measured.gripperSerial = u"VG-1"_s;
        measured.forceLag_s = 2.5e-5;
        measured.chain.forceLagUncertainty_s = 5e-6;
        measured.chain.forceScaleUncertainty = 0.25;
        const auto library = Library::open(m_work.path(u"lib.db"_s));
        QVERIFY(library && (*library)->addMeasuringChain(measured));
    }
    void aRecordingHasTheChainOfItsGripper()
    {
        QVERIFY(!textOf(u"before.csv"_s).contains("force_lag_s"));
        const ProgramRun run = record(u"after.csv"_s, {u"--library"_s, u"lib.db"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(run.err.contains("VG-1"));
        const QByteArray text = textOf(u"after.csv"_s);
        for (const char* line : {"# force_lag_s: 2.5e-05\n", "# force_lag_uncertainty_s: 5e-06\n",
                                 "# force_scale_uncertainty: 0.25\n"})
            QVERIFY2(text.contains(line), text.left(600).constData());
    }
    void aRecordingIsCorrectedByTheCalibrationOfItsGripper()
    {
        {
            // A force channel that reads a tenth too much.
            SensorCalibration calibration;
            calibration.gripperSerial = u"VG-1"_s;
            calibration.gripperName = u"Gripper"_s;
            calibration.channel = SensorChannel::Force;
            calibration.unit = u"N"_s;
            calibration.reference = {u"weights"_s, u"K-1"_s, 0.01, 0};
            calibration.degree = 1;
            calibration.takenUtc = QDateTime::currentDateTimeUtc();
            calibration.due = QDate::currentDate().addYears(1);
            for (const double load : {0.0, 20.0, 40.0, 60.0, 40.0, 20.0, 0.0})
                calibration.points.push_back({load, load * 1.1 + 0.001 * (load > 30 ? 1 : -1)});
            const auto library = Library::open(m_work.path(u"calibrated.db"_s));
            QVERIFY(library && (*library)->addCalibration(calibration));
        }
        const ProgramRun run = record(u"corrected.csv"_s, {u"--library"_s, u"calibrated.db"_s});
        QVERIFY2(run.exit == 0 && run.err.contains("Its force is corrected by the calibration"),
                 run.err.constData());
        const auto plain = readRecordingCsv(m_work.path(u"before.csv"_s));
        const auto corrected = readRecordingCsv(m_work.path(u"corrected.csv"_s));
        QVERIFY(plain && corrected);
        const auto largest = [](const Recording& recording) {
            return *std::max_element(recording.force.begin(), recording.force.end());
        };
        // 30 N at the most; the noise of the channel is far below a hundredth of that.
        QVERIFY(std::abs(1.1 * largest(*corrected) / largest(*plain) - 1) < 0.01);
    }
    void identifyUsesItForARecordingThatHasNone()
    {
        const auto calibration = [](const ProgramRun& run) {
            for (const QJsonValue& line : run.json()[u"budget"][u"lines"].toArray())
                if (line[u"id"].toString() == u"calibration")
                    return true;
            return false;
        };
        const QStringList identifying{u"identify"_s, u"--estimator"_s, u"oe"_s, u"--json"_s, u"before.csv"_s};
        QVERIFY(!calibration(m_work.cli(identifying)));
        const ProgramRun run = m_work.cli(identifying + QStringList{u"--library"_s, u"lib.db"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY2(calibration(run), run.out.constData());
        QVERIFY2(run.err.contains("before.csv") && run.err.contains("VG-1") && run.err.contains("25 us"),
                 run.err.constData());

        QByteArray stated = textOf(u"before.csv"_s);
        stated.replace("# force_unit", "# force_lag_s: 0\n# force_unit");
        m_work.write(u"stated.csv"_s, stated);
        const ProgramRun own =
            m_work.cli({u"identify"_s, u"--library"_s, u"lib.db"_s, u"--json"_s, u"stated.csv"_s});
        QVERIFY2(own.err.contains("the file's own lag"), own.err.constData());
        QCOMPARE(m_work.cli(identifying + QStringList{u"--library"_s, u"none.db"_s}).exit, 5);
        QVERIFY(!QFile::exists(m_work.path(u"none.db"_s)));
    }
    void enrollAndClassifyUseItToo()
    {
        const ProgramRun enrolled =
            m_work.cli({u"enroll"_s, u"--library"_s, u"lib.db"_s, u"--type"_s, u"A"_s, u"before.csv"_s});
        QVERIFY2(enrolled.exit == 0 && enrolled.err.contains("measuring chain of gripper VG-1"),
                 enrolled.err.constData());
        const ProgramRun classified =
            m_work.cli({u"classify"_s, u"--library"_s, u"lib.db"_s, u"before.csv"_s});
        QVERIFY2(classified.err.contains("measuring chain of gripper VG-1"), classified.err.constData());
    }
    void filesOfOneGripperTellTheHoldTogether()
    {
        QStringList files;
        for (int seed = 1; seed <= 6; ++seed) {
            const QString file = u"squeeze%1.csv"_s.arg(seed);
            QCOMPARE(m_work
                         .cli({u"simulate"_s, u"--object"_s, u"0.04,0.08,0.16"_s, u"--bit"_s, u"0.5"_s,
                               u"--samples"_s, u"400"_s, u"--noise-sd"_s, u"0.9"_s, u"--seed"_s,
                               QString::number(seed), u"--hold"_s, u"zoh"_s, u"-o"_s, file})
                         .exit,
                     0);
            files << file;
        }
        const QList<QJsonObject> documents =
            m_work.cli(QStringList{u"identify"_s, u"--hold"_s, u"foh"_s, u"--json"_s} + files).jsonLines();
        QCOMPARE(documents.size(), 6);
        double sum = 0;
        for (int i = 0; i < 6; ++i) {
            const QJsonObject hold = documents[i][u"hold"].toObject();
            sum += hold[u"gain"].toDouble();
            QCOMPARE(hold[u"summed"][u"squeezes"].toInt(), i + 1);
            QCOMPARE(hold[u"summed"][u"gain"].toDouble(), sum);
        }
        // Alone none of them tells; together they do.
        QCOMPARE(documents.last()[u"hold"][u"limit"].toDouble(), 10.0);
        QVERIFY(documents.last()[u"hold"][u"gain"].toDouble() < 10);
        for (const QJsonValue& check : documents.last()[u"validity"][u"checks"].toArray())
            if (check[u"id"].toString() == u"hold") {
                QVERIFY(!check[u"ok"].toBool());
                QVERIFY(check[u"message"].toString().contains(u"over 6 squeezes"_s));
            }
    }
};

GRIPSCOPE_TEST(MeasuringChainCommandTest)
#include "measuring_chain_command_test.moc"
