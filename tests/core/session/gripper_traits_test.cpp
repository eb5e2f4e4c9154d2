// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/gripper_traits.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class GripperTraitsTest : public QObject {
    Q_OBJECT
private slots:
    void eachTraitHasTheDateOfItsOwnMeasurement()
    {
        // The lag was measured first, the empty gripper later, the frame last; each entry holds all of it.
        MeasuringChainRecord lag;
        lag.forceLag_s = 1e-4;
        lag.basis = u"lag"_s;
        MeasuringChainRecord empty = lag;
        empty.chain.baseline = GripperBaseline{{0.01, 2, 300}, {0.001, 0.2, 30}};
        empty.chain.friction = GripperFriction{0.3, 0.01};
        empty.basis = u"empty"_s;
        MeasuringChainRecord frame = empty;
        frame.chain.frameCompliance = 1e-6;
        frame.basis = u"frame"_s;
        const std::vector<MeasuringChainRecord> all{frame, empty, lag};
        QCOMPARE(measurementOf(GripperTrait::Lag, all)->basis, u"lag"_s);
        QCOMPARE(measurementOf(GripperTrait::Baseline, all)->basis, u"empty"_s);
        QCOMPARE(measurementOf(GripperTrait::Friction, all)->basis, u"empty"_s);
        QCOMPARE(measurementOf(GripperTrait::Frame, all)->basis, u"frame"_s);
        QVERIFY(!measurementOf(GripperTrait::ForceNoise, all));
    }
    void whatWasTakenAwayIsNotKnown()
    {
        MeasuringChainRecord before;
        before.chain.friction = GripperFriction{0.3, 0.01};
        const std::vector<MeasuringChainRecord> all{MeasuringChainRecord(), before};
        QVERIFY(!measurementOf(GripperTrait::Friction, all));
        QVERIFY(!measurementOf(GripperTrait::Friction, {}));
    }
};

GRIPSCOPE_TEST(GripperTraitsTest)
#include "gripper_traits_test.moc"
