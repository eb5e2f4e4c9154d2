// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/squeeze_job.h"
#include "core/session/squeeze/stored_chain.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

MeasuringChainRecord known()
{
    MeasuringChainRecord record;
    record.gripperSerial = u"G-1"_s;
    record.forceLag_s = 1.2e-4;
    record.chain.forceLagUncertainty_s = 3e-6;
    record.chain.forceScaleUncertainty = 0.002;
    record.measured = QDateTime(QDate(2026, 3, 4), QTime(5, 6), Qt::UTC);
    return record;
}

} // namespace

class StoredChainTest : public QObject {
    Q_OBJECT
private slots:
    void aRecordingWithoutAChainGetsTheLibrarys()
    {
        Recording recording;
        QVERIFY(completeChain(recording, known()) == ChainUse::Stored);
        QCOMPARE(recording.forceLag_s, 1.2e-4);
        QVERIFY(recording.chain == known().chain);
        QVERIFY(recording.provenance[u"measuring_chain_source"_s].contains(u"2026-03-04"_s));
    }
    void aChainOfItsOwnStays()
    {
        Recording recording;
        recording.chain.positionScaleUncertainty = 0.001;
        const Recording before = recording;
        QVERIFY(completeChain(recording, known()) == ChainUse::Own);
        QVERIFY(recording == before);
    }
    void aStatedLagStaysAndTheUncertaintyOfAnotherIsNotPutBesideIt_data()
    {
        QTest::addColumn<QByteArray>("lag");
        QTest::newRow("some") << QByteArray("5e-05");
        QTest::newRow("none, as stated") << QByteArray("0");
    }
    void aStatedLagStaysAndTheUncertaintyOfAnotherIsNotPutBesideIt()
    {
        QFETCH(QByteArray, lag);
        auto recording = parseRecordingCsv(
            "# force_lag_s: " + lag + "\ntime_s,force,position\n0,1,2\n0.1,1,2\n0.2,1,2\n", u"x.csv"_s);
        QVERIFY(recording);
        QVERIFY(completeChain(*recording, known()) == ChainUse::StoredRest);
        QCOMPARE(recording->forceLag_s, lag.toDouble());
        QCOMPARE(recording->chain.forceLagUncertainty_s, 0.0);
        QCOMPARE(recording->chain.forceScaleUncertainty, 0.002);
    }
    void aConnectionTakesItForTheSqueezesToCome()
    {
        test::ArmedConnection connection;
        QVERIFY(connection.open());
        putInForce(connection.session, KnownGripper{known(), {}});
        QCOMPARE(connection.session.forceLag_s(), 1.2e-4);
        QVERIFY(connection.session.measuringChain() == known().chain);
    }
    void nothingIsSqueezedBeforeTheLibraryHasAnswered()
    {
        test::ArmedConnection connection;
        connection.session.awaitCalibrations(true);
        QVERIFY(connection.open());
        SqueezeJob job(connection.session);
        const auto refusal = [&] { return job.start(Recipe{}, 1).error().describe(); };
        QVERIFY2(refusal().contains(u"still being asked"_s), qPrintable(refusal()));
        QVERIFY(!job.listen(1)); // which is recorded uncorrected, too
        connection.session.tellCalibrationsUnread({ErrorCode::StorageFailed, {u"read"_s, u"locked"_s}});
        QVERIFY2(refusal().contains(u"could not be read"_s) && refusal().contains(u"locked"_s),
                 qPrintable(refusal()));
        QCOMPARE(connection.gripper().started, 0);
        putInForce(connection.session, {}); // it knows nothing: that is an answer
        QVERIFY(job.start(Recipe{}, 1));
        job.cancel();
        // The next gripper is another question; one that nobody asks is not waited for.
        QVERIFY(connection.open(false));
        QVERIFY(!connection.session.calibrationsTold());
        connection.session.awaitCalibrations(false);
        QVERIFY(connection.session.calibrationsTold());
    }
    void allThatALibraryKnowsIsPutInForceAtOnce()
    {
        const QTemporaryDir folder;
        auto library = Library::open(folder.filePath(u"library.db"_s));
        QVERIFY(library);
        NewMeasuringChain measured;
        measured.gripperSerial = u"F-1"_s; // the fake gripper's
        measured.forceLag_s = 1.2e-4;
        measured.chain.forceNoiseDeviation = 0.002;
        measured.chain.baseline = GripperBaseline{{0.004, 4, 900}, {1e-5, 0.01, 5}};
        QVERIFY((*library)->addMeasuringChain(measured));
        SensorCalibration calibration; // reads a tenth too much
        calibration.gripperSerial = u"F-1"_s;
        calibration.channel = SensorChannel::Force;
        calibration.unit = u"N"_s;
        calibration.reference = {u"Weights"_s, u"K-1"_s, 0.01, 0};
        calibration.degree = 1;
        for (const double load : {0.0, 10.0, 20.0, 40.0, 20.0, 0.0})
            calibration.points.push_back({load, 1.1 * load + (load > 15 ? 0.001 : -0.001)});
        calibration.takenUtc = QDateTime::currentDateTimeUtc();
        calibration.due = QDate::currentDate().addYears(1);
        QVERIFY((*library)->addCalibration(calibration));

        const auto gripper = knownGripper(**library, u"F-1"_s);
        QVERIFY(gripper);
        test::ArmedConnection connection;
        QVERIFY(connection.open());
        putInForce(connection.session, *gripper);
        QCOMPARE(connection.session.forceLag_s(), 1.2e-4);
        QVERIFY(connection.session.measuringChain() == measured.chain);
        QVERIFY(connection.session.calibration().record(SensorChannel::Force));
        QVERIFY(std::abs(connection.session.uncorrected(SensorChannel::Force, 20) - 22) < 0.02);
        const auto nobody = knownGripper(**library, QString());
        QVERIFY(nobody && !nobody->chain && !nobody->calibrations.force);
    }
};

GRIPSCOPE_TEST(StoredChainTest)
#include "stored_chain_test.moc"
