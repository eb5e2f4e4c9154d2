// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/measuring_sessions.h"
#include "tests/core/session/series_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class LagSessionTest : public QObject, SeriesFixture<LagSession> {
    Q_OBJECT
private slots:
    void init()
    {
        makeGripper();
        QVERIFY(makeSession());
    }
    void cleanup() { clear(); }

    void theLagIsFoundKeptAndPutInForce()
    {
        m_connection->gripper().trueLag_s = 1.2e-4;
        QVERIFY(m_session->start({}, 3));
        QVERIFY(until(State::Measured));
        const LagEstimate& lag = m_session->result();
        QCOMPARE(m_session->squeezes().size(), std::size_t(3));
        QCOMPARE(lag.status, LagStatus::Measured);
        // Four standard errors: once in 16,000; and these must be of use, a hundredth of a sample.
        QVERIFY(std::abs(lag.lag_s - 1.2e-4) < 4 * lag.standardError_s);
        QVERIFY(lag.standardError_s > 0 && lag.standardError_s < 5e-6);
        QVERIFY(!storedChain());
        QVERIFY(m_session->accept());
        QVERIFY(until(State::Stored));
        QCOMPARE(storedChain()->forceLag_s, lag.lag_s);
        QCOMPARE(storedChain()->chain.forceLagUncertainty_s, lag.standardError_s);
        QCOMPARE(storedChain()->operatorName, u"Ada"_s);
        QCOMPARE(m_connection->session.forceLag_s(), lag.lag_s);
    }
    void whatElseIsKnownOfTheChannelsStays()
    {
        MeasuringChain chain;
        chain.forceScaleUncertainty = 0.003;
        m_connection->session.setMeasuringChain(0, chain);
        QVERIFY(m_session->start({}, 2));
        QVERIFY(until(State::Measured));
        QVERIFY(m_session->accept());
        QVERIFY(until(State::Stored));
        QCOMPARE(storedChain()->chain.forceScaleUncertainty, 0.003);
    }
    void nothingIsAcceptedBeforeItIsMeasured()
    {
        QVERIFY(!m_session->accept());
        QVERIFY(m_session->start({}, 2));
        QVERIFY(!m_session->accept());
        QVERIFY(!m_session->start({}, 2));
    }
    void aGripperThatIsNotArmedIsNotMoved()
    {
        m_connection->session.disarm();
        QVERIFY(!m_session->start({}));
        QCOMPARE(m_session->state(), State::Idle);
        QCOMPARE(m_connection->gripper().started, 0);
    }
    void cancellingStopsTheGripperAndLeavesNothingBehind()
    {
        m_connection->gripper().neverStarts = true;
        QVERIFY(m_session->start({}));
        m_session->cancel();
        QCOMPARE(m_session->state(), State::Failed);
        QVERIFY(m_connection->gripper().stops > 0);
        QVERIFY(!storedChain());
    }
    void aGripperThatGoesAwaySaysSo()
    {
        m_connection->gripper().lostAfterSamples = 500;
        QVERIFY(m_session->start({}));
        QVERIFY(!until(State::Measured));
        QCOMPARE(m_session->error()->code, ErrorCode::DeviceLost);
    }
};

GRIPSCOPE_TEST(LagSessionTest)
#include "lag_session_test.moc"
