// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/connect_session.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using ConnectState = ConnectSession::State;

namespace {

/// Unplugged while it was armed, and noticed.
void unplug(ArmedConnection& connection)
{
    connection.gripper().state = LinkState::Lost;
    connection.gripper().error =
        Error{ErrorCode::DeviceLost, {QStringLiteral("fake:"), QStringLiteral("unplugged")}};
    connection.session.poll();
}

/// Plugged in again: counts from zero, and is not armed. A gripper with another serial number comes as such.
std::shared_ptr<FakeGripper> plugIn(ArmedConnection& connection,
                                    const QString& serial = QStringLiteral("F-1"))
{
    auto gripper = std::make_shared<FakeGripper>();
    gripper->identity.serial = serial;
    connection.factory.comeback->there = gripper;
    connection.session.poll(); // which opens it
    connection.session.poll();
    return gripper;
}

} // namespace

class ConnectSessionTest : public QObject {
    Q_OBJECT
private slots:
    void opensThenHandsOnEverySampleOnce()
    {
        FakeGripperFactory factory;
        factory.gripper->opensAtOnce = false;
        ConnectSession session(factory);
        QVERIFY(session.connectTo(QStringLiteral("fake:")));
        QCOMPARE(session.state(), ConnectState::Connecting);
        QVERIFY(!session.port());
        factory.gripper->state = LinkState::Ready;
        std::vector<std::uint64_t> heard;
        session.addListener([&](const std::vector<Sample>& batch) {
            for (const Sample& sample : batch)
                heard.push_back(sample.sequence);
        });
        for (int i = 0; i < 250; ++i)
            factory.gripper->push(1, 2, 0);
        for (int i = 0; i < 10; ++i)
            session.poll();
        QCOMPARE(session.state(), ConnectState::Connected);
        QCOMPARE(session.identity().serial, QStringLiteral("F-1"));
        QCOMPARE(heard.size(), std::size_t(250));
        for (std::size_t i = 0; i < heard.size(); ++i)
            QCOMPARE(heard[i], std::uint64_t(i));
        QVERIFY(factory.gripper->confirmed >= 10);
    }
    void theFirstSamplesWaitForAListener()
    {
        ArmedConnection connection;
        connection.gripper().push(1, 2, 0);
        QVERIFY(connection.open(false));
        int heard = 0;
        connection.session.addListener([&](const std::vector<Sample>& batch) { heard += int(batch.size()); });
        connection.session.poll();
        QCOMPARE(heard, 1);
    }
    void aListenerMayRemoveItselfAndAddAnother()
    {
        ArmedConnection connection;
        QVERIFY(connection.open(false));
        int first = 0, second = 0, handle = 0;
        handle = connection.session.addListener([&](const std::vector<Sample>&) {
            ++first;
            connection.session.removeListener(handle);
            connection.session.addListener([&](const std::vector<Sample>&) { ++second; });
        });
        for (int i = 0; i < 3; ++i) {
            connection.gripper().push(0, 0, 0);
            connection.session.poll();
        }
        QCOMPARE(first, 1);
        QCOMPARE(second, 2);
    }
    void aGripperThatSaysNonsenseOfItselfIsRefused_data()
    {
        QTest::addColumn<double>("sampleTime");
        QTest::addColumn<double>("lag");
        QTest::addColumn<QString>("word");
        for (const double sampleTime : {1e-15, 0.0, -1.0, 10.0, std::nan(""), HUGE_VAL})
            QTest::addRow("sample time %g", sampleTime) << sampleTime << 0.0 << QStringLiteral("sample time");
        for (const double lag : {5.0, -5.0, std::nan("")})
            QTest::addRow("lag %g", lag) << 0.001 << lag << QStringLiteral("lag");
    }
    void aGripperThatSaysNonsenseOfItselfIsRefused()
    {
        QFETCH(double, sampleTime);
        QFETCH(double, lag);
        QFETCH(QString, word);
        ArmedConnection connection;
        connection.gripper().identity.sampleTime_s = sampleTime;
        connection.gripper().identity.forceLag_s = lag;
        QVERIFY(!connection.open(false));
        QCOMPARE(connection.session.state(), ConnectState::Disconnected);
        QCOMPARE(connection.session.lastError()->code, ErrorCode::DeviceRefused);
        QVERIFY(connection.session.lastError()->describe().contains(word));
        QVERIFY(!connection.session.gate());
        QVERIFY(!connection.session.arm(QStringLiteral("Ada")));
    }
    void aLossIsToldWithItsReasonAfterTheLastSamples()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        int heard = 0;
        connection.session.addListener([&](const std::vector<Sample>& batch) { heard += int(batch.size()); });
        connection.gripper().push(0, 0, 0);
        connection.gripper().state = LinkState::Lost;
        connection.gripper().error =
            Error{ErrorCode::DeviceLost, {QStringLiteral("fake:"), QStringLiteral("unplugged")}};
        connection.session.poll();
        QCOMPARE(heard, 1);
        QCOMPARE(connection.session.state(), ConnectState::Lost);
        QCOMPARE(connection.session.lastError()->code, ErrorCode::DeviceLost);
        QVERIFY(!connection.session.port());
        QVERIFY(!connection.session.gate());
        QCOMPARE(connection.session.identity().serial, QStringLiteral("F-1")); // it can still be named
        QVERIFY(!connection.session.arm(QStringLiteral("Ada")));
    }
    void afterALossTheSameGripperCanBeConnectedAgain()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        connection.gripper().state = LinkState::Lost;
        connection.session.poll();
        QVERIFY(connection.open(false));
        QVERIFY(!connection.session.lastError());
        QVERIFY(!connection.session.armed());
    }
    void aGripperThatComesBackIsConnectedByItselfAndNotArmed()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        MeasuringChain chain;
        chain.forceLagUncertainty_s = 1e-5;
        connection.session.setMeasuringChain(2e-4, chain);
        QVERIFY(!connection.session.awaiting());
        unplug(connection);
        QCOMPARE(connection.session.state(), ConnectState::Lost);
        QVERIFY(connection.session.awaiting());
        QCOMPARE(connection.factory.comeback->awaited->identity.serial, QStringLiteral("F-1"));
        const auto back = plugIn(connection);
        QCOMPARE(connection.session.state(), ConnectState::Connected);
        QVERIFY(!connection.session.lastError());
        QVERIFY(!connection.session.awaiting());
        QVERIFY(!connection.factory.comeback->looking);
        QCOMPARE(connection.session.reconnections(), 1);
        QVERIFY(!connection.session.armed());
        QCOMPARE(back->armRequests, 0);
        QCOMPARE(connection.session.forceLag_s(), 2e-4);
        QVERIFY(connection.session.measuringChain() == chain);
        QVERIFY(connection.session.arm(QStringLiteral("Ada"))); // a person may
        QCOMPARE(back->armRequests, 1);
    }
    void lossesOfAllItsLinksAreCounted()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        connection.gripper().counters.lostSamples = 7;
        connection.gripper().counters.samples = 100;
        unplug(connection);
        const auto back = plugIn(connection);
        back->counters.lostSamples = 5;
        back->counters.samples = 50;
        connection.session.poll();
        QCOMPARE(connection.session.counters().lostSamples, std::uint64_t(12));
        QCOMPARE(connection.session.counters().samples, std::uint64_t(150));
        QVERIFY(connection.open(false)); // a person connects: counted from nothing
        QCOMPARE(connection.session.reconnections(), 0);
    }
    void oneThatOpensTwiceAndSendsNothingIsNotWorthAThirdTry()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        unplug(connection);
        QVERIFY(connection.factory.comeback->awaited->worthATry);
        const auto silent = plugIn(connection);
        QCOMPARE(connection.session.state(), ConnectState::Connected);
        silent->state = LinkState::Lost;
        connection.session.poll();
        QVERIFY(!connection.factory.comeback->awaited->worthATry);
        const auto speaking = plugIn(connection);
        speaking->counters.samples = 1;
        speaking->state = LinkState::Lost;
        connection.session.poll();
        QVERIFY(connection.factory.comeback->awaited->worthATry);
    }
    void anotherGripperInItsPlaceIsNotTakenForIt()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        unplug(connection);
        (void)plugIn(connection, QStringLiteral("F-2"));
        QCOMPARE(connection.session.state(), ConnectState::Lost);
        QVERIFY(connection.session.lastError()->describe().contains(QStringLiteral("F-2")));
        QVERIFY(connection.session.awaiting());
        (void)plugIn(connection);
        QCOMPARE(connection.session.state(), ConnectState::Connected);
        QCOMPARE(connection.session.identity().serial, QStringLiteral("F-1"));
    }
    void oneThatComesBackAndDoesNotOpenIsTriedAgain()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        unplug(connection);
        auto shut = std::make_shared<FakeGripper>();
        shut->opensAtOnce = false;
        connection.factory.comeback->there = shut;
        connection.session.poll();
        shut->state = LinkState::Lost;
        shut->error = Error{ErrorCode::DevicePermission, {QStringLiteral("fake:"), QStringLiteral("ask")}};
        connection.session.poll();
        QCOMPARE(connection.session.state(), ConnectState::Lost);
        QCOMPARE(connection.session.lastError()->code, ErrorCode::DevicePermission);
        QVERIFY(connection.session.awaiting());
        (void)plugIn(connection);
        QCOMPARE(connection.session.state(), ConnectState::Connected);
    }
    void oneThatIsNotThereYetIsConnectedWhenItComes()
    {
        ArmedConnection connection;
        connection.gripper().opensAtOnce = false;
        QVERIFY(connection.session.connectTo(QStringLiteral("fake:")));
        connection.gripper().state = LinkState::Lost;
        connection.gripper().error = Error{ErrorCode::DeviceNotFound, {QStringLiteral("fake:"), {}}};
        connection.session.poll();
        QCOMPARE(connection.session.state(), ConnectState::Lost);
        QVERIFY(connection.session.awaiting());
        (void)plugIn(connection, QStringLiteral("F-9"));
        QCOMPARE(connection.session.state(), ConnectState::Connected);
        QCOMPARE(connection.session.reconnections(), 0); // it had not been here before
    }
    void anAddressThatCannotComeRightIsNotWaitedFor()
    {
        ArmedConnection connection;
        connection.gripper().opensAtOnce = false;
        QVERIFY(connection.session.connectTo(QStringLiteral("fake:")));
        connection.gripper().state = LinkState::Lost;
        connection.gripper().error = Error{ErrorCode::DeviceAmbiguous, {QStringLiteral("fake:1, fake:2")}};
        connection.session.poll();
        QCOMPARE(connection.session.state(), ConnectState::Lost);
        QVERIFY(!connection.session.awaiting());
    }
    void disconnectingEndsTheLookingOut()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        unplug(connection);
        connection.session.disconnect();
        QVERIFY(!connection.factory.comeback->looking);
        (void)plugIn(connection);
        QCOMPARE(connection.session.state(), ConnectState::Disconnected);
    }
    void theEndOfAStreamIsNoLoss()
    {
        ArmedConnection connection;
        QVERIFY(connection.open(false));
        connection.gripper().state = LinkState::Closed;
        connection.session.poll();
        QCOMPARE(connection.session.state(), ConnectState::Disconnected);
        QVERIFY(connection.session.streamEnded());
        connection.session.disconnect();
        QVERIFY(!connection.session.streamEnded());
    }
    void disconnectingStopsAnArmedGripperAndCloses()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        connection.session.disconnect();
        QCOMPARE(connection.gripper().stops.load(), 1);
        QCOMPARE(connection.gripper().closed, 1);
        QCOMPARE(connection.session.state(), ConnectState::Disconnected);
    }
    void anAddressThatMakesNoPortIsAnError()
    {
        FakeGripperFactory factory;
        factory.refuses = Error{ErrorCode::Usage, {QStringLiteral("no such address")}};
        ConnectSession session(factory);
        QVERIFY(!session.connectTo(QStringLiteral("nonsense:")));
        QCOMPARE(session.state(), ConnectState::Disconnected);
        QCOMPARE(session.lastError()->code, ErrorCode::Usage);
    }
    void anAddressThatMakesNoPortLeavesTheGripperThatWorks()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        connection.factory.refuses = Error{ErrorCode::Usage, {QStringLiteral("no such address")}};
        const Expected<void> done = connection.session.connectTo(QStringLiteral("nonsense:"));
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::Usage);
        connection.session.poll();
        QCOMPARE(connection.session.state(), ConnectState::Connected);
        QVERIFY(connection.session.armed());
        QCOMPARE(connection.gripper().closed, 0);
        QCOMPARE(connection.session.address(), QStringLiteral("fake:"));
    }
    void whatDidNotObeyStopIsNotArmedUntilItWasConnectedAnew()
    {
        ArmedConnection connection;
        QVERIFY(connection.open());
        connection.gripper().obeysStop = false;
        connection.session.stop();
        connection.session.poll();
        QCOMPARE(connection.session.stopState(), StopState::NotObeyed);
        const int asked = connection.gripper().armRequests;
        const Expected<void> armed = connection.session.arm(QStringLiteral("Ada"));
        QVERIFY(!armed);
        QCOMPARE(armed.error().describe(),
                 QStringLiteral("The gripper did not obey Stop. Switch off its power."));
        QCOMPARE(connection.gripper().armRequests, asked);
        unplug(connection);
        QCOMPARE(connection.session.stopState(), StopState::NotObeyed); // not by going away
        (void)plugIn(connection);
        QCOMPARE(connection.session.stopState(), StopState::None);
        QVERIFY(connection.session.arm(QStringLiteral("Ada")));
    }
    void nothingIsArmedWithoutAConnection()
    {
        FakeGripperFactory factory;
        ConnectSession session(factory);
        QCOMPARE(session.arm(QStringLiteral("Ada")).error().code, ErrorCode::DeviceRefused);
        session.stop(); // nothing to stop, and no harm
        session.disarm();
        session.poll();
        QCOMPARE(session.state(), ConnectState::Disconnected);
    }
};

GRIPSCOPE_TEST(ConnectSessionTest)
#include "connect_session_test.moc"
