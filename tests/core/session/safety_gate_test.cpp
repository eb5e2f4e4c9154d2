// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/safety_gate.h"
#include "tests/core/session/fake_gripper.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using namespace gripscope::test;

class SafetyGateTest : public QObject {
    Q_OBJECT
private:
    std::shared_ptr<FakeGripper> m_gripper;
    std::unique_ptr<FakeGripperPort> m_port;
    std::unique_ptr<SafetyGate> m_gate;

private slots:
    void init()
    {
        m_gripper = std::make_shared<FakeGripper>();
        m_gripper->state = LinkState::Ready;
        m_port = std::make_unique<FakeGripperPort>(m_gripper);
        m_gate = std::make_unique<SafetyGate>(*m_port);
        m_gate->setJobLimits({40, 0.02});
    }
    void theLowerOfTheTwoLimitsHolds()
    {
        QCOMPARE(m_gate->effectiveLimits().maxForce_N, 40.0);
        QCOMPARE(m_gate->effectiveLimits().maxTravel_m, 0.02);
        m_gripper->identity.limits = {30, 0.01, 100};
        QCOMPARE(m_gate->effectiveLimits().maxForce_N, 30.0);
        QCOMPARE(m_gate->effectiveLimits().maxTravel_m, 0.01);
    }
    void whatIsRefused_data()
    {
        QTest::addColumn<QVector<double>>("force_N");
        QTest::addColumn<int>("code");
        QTest::newRow("at the limit") << QVector<double>{0, 40} << -1;
        QTest::newRow("above the limit")
            << QVector<double>{0, 40.000001} << static_cast<int>(ErrorCode::LimitExceeded);
        QTest::newRow("empty") << QVector<double>{} << static_cast<int>(ErrorCode::Usage);
        QTest::newRow("pulls") << QVector<double>{10, -1e-9} << static_cast<int>(ErrorCode::Usage);
        QTest::newRow("NaN") << QVector<double>{1, std::numeric_limits<double>::quiet_NaN()}
                             << static_cast<int>(ErrorCode::Usage);
        QTest::newRow("infinite") << QVector<double>{std::numeric_limits<double>::infinity()}
                                  << static_cast<int>(ErrorCode::Usage);
        QTest::newRow("longer than the device holds")
            << QVector<double>(20001, 1.0) << static_cast<int>(ErrorCode::Usage);
    }
    void whatIsRefused()
    {
        QFETCH(QVector<double>, force_N);
        QFETCH(int, code);
        QVERIFY(m_gate->arm(QStringLiteral("Ada")));
        const Expected<void> started = m_gate->start({force_N.begin(), force_N.end()});
        QCOMPARE(started ? -1 : static_cast<int>(started.error().code), code);
        QCOMPARE(m_gripper->started, code == -1 ? 1 : 0);
    }
    void limitsThatAreNoneAreRefused()
    {
        QVERIFY(m_gate->arm(QStringLiteral("Ada")));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const JobLimits& limits :
             {JobLimits{nan, 0.02}, JobLimits{0, 0.02}, JobLimits{-40, 0.02}, JobLimits{40, nan},
              JobLimits{40, 0}, JobLimits{std::numeric_limits<double>::infinity(), 0.02}}) {
            m_gate->setJobLimits(limits);
            QCOMPARE(m_gate->start({1, 2}).error().code, ErrorCode::Usage);
        }
        QCOMPARE(m_gripper->started, 0);
    }
    void nothingMovesBeforeAPersonArmed()
    {
        const Expected<void> early = m_gate->start({1, 2});
        QVERIFY(!early);
        QCOMPARE(early.error().code, ErrorCode::NotArmed);
        QCOMPARE(m_gripper->started, 0);
        QVERIFY(!m_gate->arm(QStringLiteral("  ")));
        QVERIFY(m_gate->arm(QStringLiteral(" Ada ")));
        QCOMPARE(m_gripper->armedBy, QStringLiteral("Ada"));
        QVERIFY(m_gate->start({1, 2}));
        QCOMPARE(m_gripper->commanded_N, (std::vector<double>{1, 2}));
        QCOMPARE(m_gripper->admittedMaxForce_N, 40.0);
    }
    void aDeviceThatOnlyListensIsNeitherArmedNorMoved()
    {
        m_gripper->identity.commandable = false;
        QCOMPARE(m_gate->arm(QStringLiteral("Ada")).error().code, ErrorCode::DeviceRefused);
        QCOMPARE(m_gate->start({1}).error().code, ErrorCode::DeviceRefused);
        QCOMPARE(m_gripper->armRequests + m_gripper->started, 0);
    }
    void theMessageSaysWhoseLimitItIs()
    {
        QVERIFY(m_gate->admit({50}).error().describe().contains(QStringLiteral("recipe")));
        m_gripper->identity.limits.maxForce_N = 30;
        QVERIFY(m_gate->admit({50}).error().describe().contains(QStringLiteral("gripper's own")));
    }
};

GRIPSCOPE_TEST(SafetyGateTest)
#include "safety_gate_test.moc"
