// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/emergency/end_signals.h"
#include "tests/devices/watched_transport.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <csignal>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class EndSignalsTest : public QObject {
    Q_OBJECT
private slots:
    void whoIsAskedToEndStopsItsGrippersFirst_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl-C") << SIGINT;
        QTest::newRow("shutdown") << SIGTERM;
        QTest::newRow("logout, or the terminal closed") << SIGHUP;
    }
    void whoIsAskedToEndStopsItsGrippersFirst()
    {
        QFETCH(int, signal);
        std::atomic<bool> told{false};
        Watched first(Watched::transport(1)), second(Watched::transport(1));
        {
            const EndSignals ending([&] { told = true; });
            for (Watched* gripper : {&first, &second})
                QVERIFY(gripper->ready() && gripper->squeezesForLong());
            QCOMPARE(raise(signal), 0);
            // The owner of the grippers does nothing: nobody polls.
            QVERIFY(waitFor([&] { return told.load(); }));
            QVERIFY(waitFor([&] { return first.wire->stopWritten != 0 && second.wire->stopWritten != 0; }));
        }
        for (Watched* gripper : {&first, &second})
            QVERIFY(
                gripper->pollUntil([&] { return gripper->port->squeezeState() == SqueezeState::Stopped; }));
    }

    void withoutASignalNothingHappens()
    {
        std::atomic<bool> told{false};
        {
            const EndSignals ending([&] { told = true; });
        }
        QVERIFY(!told);
    }
};

GRIPSCOPE_TEST(EndSignalsTest)
#include "end_signals_test.moc"
