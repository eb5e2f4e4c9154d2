// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/lag_session.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class LagSessionTest : public QObject {
    Q_OBJECT
    using State = LagSession::State;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<LibraryService> m_library;
    std::unique_ptr<ArmedConnection> m_connection;
    std::unique_ptr<LagSession> m_session;

    bool until(State state)
    {
        return pollUntil(
                   [this] {
                       m_connection->session.poll();
                       m_session->poll();
                   },
                   [this, state] {
                       return m_session->state() == state || m_session->state() == State::Failed;
                   }) &&
               m_session->state() == state;
    }
    std::optional<MeasuringChainRecord> stored()
    {
        using Found = std::optional<MeasuringChainRecord>;
        return m_library->run<Found>([](Library& library) { return library.measuringChain(u"F-1"_s); })
            .get()
            .value();
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_library = std::make_unique<LibraryService>(m_folder->filePath(u"lag.db"_s));
        m_connection = std::make_unique<ArmedConnection>();
        QVERIFY(m_connection->open());
        m_session = std::make_unique<LagSession>(m_connection->session, *m_library);
        m_session->setOperator(u"Ada"_s);
    }
    void cleanup()
    {
        m_session.reset();
        m_connection.reset();
        m_library.reset();
    }

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
        QVERIFY(!stored());
        QVERIFY(m_session->accept());
        QVERIFY(until(State::Stored));
        QCOMPARE(stored()->forceLag_s, lag.lag_s);
        QCOMPARE(stored()->chain.forceLagUncertainty_s, lag.standardError_s);
        QCOMPARE(stored()->operatorName, u"Ada"_s);
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
        QCOMPARE(stored()->chain.forceScaleUncertainty, 0.003);
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
        QVERIFY(!stored());
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
