// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connect_session.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using State = ConnectSession::State;

class ConnectSessionTest : public QObject {
    Q_OBJECT
private slots:
    void opensThenHandsOnEverySampleOnce()
    {
        FakeGripperFactory factory;
        factory.gripper->opensAtOnce = false;
        ConnectSession session(factory);
        QVERIFY(session.connectTo(QStringLiteral("fake:")));
        QCOMPARE(session.state(), State::Connecting);
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
        QCOMPARE(session.state(), State::Connected);
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
        QCOMPARE(connection.session.state(), State::Lost);
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
    void theEndOfAStreamIsNoLoss()
    {
        ArmedConnection connection;
        QVERIFY(connection.open(false));
        connection.gripper().state = LinkState::Closed;
        connection.session.poll();
        QCOMPARE(connection.session.state(), State::Disconnected);
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
        QCOMPARE(connection.session.state(), State::Disconnected);
    }
    void anAddressThatMakesNoPortIsAnError()
    {
        FakeGripperFactory factory;
        factory.refuses = Error{ErrorCode::Usage, {QStringLiteral("no such address")}};
        ConnectSession session(factory);
        QVERIFY(!session.connectTo(QStringLiteral("nonsense:")));
        QCOMPARE(session.state(), State::Disconnected);
        QCOMPARE(session.lastError()->code, ErrorCode::Usage);
    }
    void nothingIsArmedWithoutAConnection()
    {
        FakeGripperFactory factory;
        ConnectSession session(factory);
        QCOMPARE(session.arm(QStringLiteral("Ada")).error().code, ErrorCode::DeviceRefused);
        session.stop(); // nothing to stop, and no harm
        session.disarm();
        session.poll();
        QCOMPARE(session.state(), State::Disconnected);
    }
};

GRIPSCOPE_TEST(ConnectSessionTest)
#include "connect_session_test.moc"
