// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/arming.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace std::chrono_literals;

/// The way from a wish to an armed gripper, in made-up time.
class ArmingTest : public QObject {
    Q_OBJECT
private slots:
    void reportsEvery20MillisecondsAreEnoughByAnyClock_data()
    {
        QTest::addColumn<int>("period_us");
        QTest::addColumn<bool>("armed");
        QTest::newRow("5 ms") << 5'000 << true;
        QTest::newRow("20 ms") << 20'000 << true;
        QTest::newRow("20 ms by a clock that is 0.5 percent slow") << 20'100 << true;
        QTest::newRow("the last report 3 ms late") << 20'333 << true;
        QTest::newRow("49 Hz and less") << 20'600 << false;
        QTest::newRow("25 ms") << 25'000 << false;
    }
    void reportsEvery20MillisecondsAreEnoughByAnyClock()
    {
        QFETCH(int, period_us);
        QFETCH(bool, armed);
        const StreamPulse::Time start{1h};
        StreamPulse pulse;
        for (std::size_t i = 0; i < StreamPulse::needed; ++i)
            pulse.take(start + i * std::chrono::microseconds(period_us));
        Arming arming(LinkLimits{}, {100ms, true});
        arming.ask(start);
        QCOMPARE(arming.sendArm(pulse, start + 240ms), armed);
        const std::optional<Arming::Refusal> refusal = arming.takeRefusal();
        QCOMPARE(refusal.has_value(), !armed);
        if (refusal)
            QVERIFY2(refusal->why.contains(u"its reports come every"), qPrintable(refusal->why));
    }
};

GRIPSCOPE_TEST(ArmingTest)

#include "arming_test.moc"
