// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using namespace gripscope::test;

namespace {

NewMeasuringChain measuredOf(const QString& serial, double lag_s)
{
    NewMeasuringChain measured;
    measured.gripperSerial = serial;
    measured.forceLag_s = lag_s;
    measured.chain.forceLagUncertainty_s = 2e-6;
    measured.chain.forceNoiseDeviation = 0.02;
    measured.chain.forceScaleUncertainty = 0.002;
    measured.chain.positionScaleUncertainty = 0.001;
    measured.chain.frameCompliance = 1e-5;
    measured.chain.frameComplianceUncertainty = 1e-6;
    measured.operatorName = u"Ada"_s;
    measured.basis = u"5 squeezes of a spring"_s;
    return measured;
}

} // namespace

class MeasuringChainTest : public QObject {
    Q_OBJECT
private slots:
    void whatWasMeasuredComesBack()
    {
        const LibraryFolder folder;
        NewMeasuringChain measured = measuredOf(u"0001"_s, 1e-4);
        measured.chain.baseline = GripperBaseline{{0.01, 2, 300}, {0.001, 0.2, 30}};
        measured.chain.friction = GripperFriction{0.3, 0.01};
        valueOf(folder.open()->addMeasuringChain(measured));
        const auto found = valueOf(folder.open()->measuringChain(u"0001"_s));
        QVERIFY(found);
        QCOMPARE(found->forceLag_s, 1e-4);
        QVERIFY(found->chain == measured.chain);
        QCOMPARE(found->operatorName, u"Ada"_s);
        QCOMPARE(found->basis, measured.basis);
        QVERIFY(std::abs(found->measured.secsTo(QDateTime::currentDateTimeUtc())) < 60);
    }
    void theNewestOfEachGripperIsInForce()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addMeasuringChain(measuredOf(u"0001"_s, 1e-4)));
        valueOf(library->addMeasuringChain(measuredOf(u"0002"_s, 3e-4)));
        valueOf(library->addMeasuringChain(measuredOf(u"0001"_s, 2e-4)));
        QCOMPARE(valueOf(library->measuringChain(u"0001"_s))->forceLag_s, 2e-4);
        QCOMPARE(valueOf(library->measuringChain(u"0002"_s))->forceLag_s, 3e-4);
        QVERIFY(!valueOf(library->measuringChain(u"0001"_s))->chain.baseline);
        QVERIFY(!valueOf(library->measuringChain(u"0003"_s)));
    }
    void allOfAGripperAreListedNewestFirst()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        for (const double lag_s : {1e-4, 2e-4, 3e-4})
            valueOf(library->addMeasuringChain(measuredOf(u"0001"_s, lag_s)));
        valueOf(library->addMeasuringChain(measuredOf(u"0002"_s, 9e-4)));
        const auto all = valueOf(library->measuringChains(u"0001"_s, 2));
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0].forceLag_s, 3e-4);
        QCOMPARE(all[1].forceLag_s, 2e-4);
    }
    void theNewestIsWhatCameLastWhateverTheClockSays()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addMeasuringChain(measuredOf(u"0001"_s, 1e-4)));
        // As though it had been stored while the clock was ahead.
        RawDatabase(folder.file())
            .run(u"UPDATE measuring_chains SET created_utc = '2099-01-01T00:00:00.000Z', id = 'ff'"_s);
        valueOf(library->addMeasuringChain(measuredOf(u"0001"_s, 2e-4)));
        QCOMPARE(valueOf(library->measuringChain(u"0001"_s))->forceLag_s, 2e-4);
    }
    void whatCannotBeKeptIsRefused()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QCOMPARE(library->addMeasuringChain(measuredOf({}, 1e-4)).error().code, ErrorCode::Usage);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(library->addMeasuringChain(measuredOf(u"0001"_s, nan)).error().code, ErrorCode::Usage);
        QVERIFY(!valueOf(library->measuringChain(u"0001"_s)));
    }
};

GRIPSCOPE_TEST(MeasuringChainTest)
#include "measuring_chain_test.moc"
