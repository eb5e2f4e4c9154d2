// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/clock_standing.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// As chronyc 4.3 prints it.
QString printed(const QString& systemTime, const QString& leap = u"Normal"_s)
{
    return u"Reference ID    : 7F7F0101 ()\nStratum         : 8\nRef time (UTC)  : Sun Nov 29 11:25:02 2026\n"
           "System time     : %1 of NTP time\nLast offset     : +0.000000000 seconds\n"
           "RMS offset      : 0.000000000 seconds\nFrequency       : 0.000 ppm slow\n"
           "Residual freq   : +0.000 ppm\nSkew            : 0.000 ppm\n"
           "Root delay      : 0.020000000 seconds\nRoot dispersion : 0.001000000 seconds\n"
           "Update interval : 0.0 seconds\nLeap status     : %2\n"_s.arg(systemTime, leap);
}

} // namespace

class ClockStandingTest : public QObject {
    Q_OBJECT
private slots:
    void theOffsetHasASignByItsWord()
    {
        const auto fast = clockStandingFrom(printed(u"3.250000000 seconds fast"_s));
        const auto slow = clockStandingFrom(printed(u"0.000006523 seconds slow"_s));
        QVERIFY(fast && slow);
        QCOMPARE(fast->offset_s, 3.25);
        QCOMPARE(slow->offset_s, -0.000006523);
        QCOMPARE(fast->dispersion_s, 0.011);
    }
    void whatIsNotKnownIsNothing()
    {
        QVERIFY(!clockStandingFrom({}));
        QVERIFY(!clockStandingFrom(u"506 Cannot talk to daemon\n"_s));
        QVERIFY(!clockStandingFrom(printed(u"0.1 seconds fast"_s, u"Not synchronised"_s)));
        QVERIFY(!clockStandingFrom(printed(u"nan seconds fast"_s)));
        QVERIFY(!clockStandingFrom(printed(u"many minutes fast"_s)));
        QVERIFY(!clockStandingFrom(printed(u"0.1 seconds fast"_s).section(u"Root disp"_s, 0, 0)));
    }
};

GRIPSCOPE_TEST(ClockStandingTest)
#include "clock_standing_test.moc"
