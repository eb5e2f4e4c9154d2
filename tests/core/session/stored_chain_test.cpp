// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/stored_chain.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <QTest>

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
        putInForce(connection.session, known());
        QCOMPARE(connection.session.forceLag_s(), 1.2e-4);
        QVERIFY(connection.session.measuringChain() == known().chain);
    }
};

GRIPSCOPE_TEST(StoredChainTest)
#include "stored_chain_test.moc"
