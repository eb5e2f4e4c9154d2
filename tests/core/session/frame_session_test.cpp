// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/measuring_sessions.h"
#include "tests/core/session/series_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {
/// A block in a frame that gives 1 um a newton.
constexpr MassDampingStiffness blockInFrame{0.05, 100, 1e6};
} // namespace

class FrameSessionTest : public QObject, SeriesFixture<FrameSession> {
    Q_OBJECT
private slots:
    void init()
    {
        makeGripper();
        m_connection->gripper().object = blockInFrame;
        QVERIFY(makeSession());
    }
    void cleanup() { clear(); }

    void whatTheFrameGivesWayIsFoundKeptAndTakenOff()
    {
        MeasuringChain known;
        known.frameCompliance = 3e-6; // of the fingers before: measured anew, not on top of it
        known.frameComplianceUncertainty = 1e-7;
        known.forceScaleUncertainty = 0.003; // stays
        m_connection->session.setMeasuringChain(0, known);
        QVERIFY(m_session->start({}, 3));
        QVERIFY(until(State::Measured));
        QVERIFY2(m_session->compliance(), qPrintable(m_session->problem()));
        const FrameCompliance found = *m_session->compliance();
        // Five standard errors of three squeezes whose scatter is estimated from themselves.
        QVERIFY2(std::abs(found.value - 1e-6) < 5 * found.standardError &&
                     found.standardError < 0.05 * found.value,
                 qPrintable(u"%1 +- %2"_s.arg(found.value).arg(found.standardError)));
        QVERIFY(!storedChain());
        QVERIFY(m_session->accept());
        QVERIFY(until(State::Stored));
        QCOMPARE(storedChain()->chain.frameCompliance, found.value);
        QCOMPARE(storedChain()->chain.frameComplianceUncertainty, found.standardError);
        QCOMPARE(storedChain()->chain.forceScaleUncertainty, 0.003);
        QCOMPARE(m_connection->session.measuringChain().frameCompliance, found.value);
    }

    void theEmptyGrippersOwnStiffnessIsNotTheFrames()
    {
        MeasuringChain known;
        known.baseline = GripperBaseline{{0.01, 10, 1e5}, {1e-4, 0.1, 10}};
        m_connection->session.setMeasuringChain(0, known);
        QVERIFY(m_session->start({}, 3));
        QVERIFY(until(State::Measured));
        QVERIFY2(m_session->compliance(), qPrintable(m_session->problem()));
        QVERIFY(std::abs(m_session->compliance()->value * 9e5 - 1) < 0.05);
    }

    void squeezesThatAreNotValidMakeNoCompliance()
    {
        m_connection->gripper().dropSample = [](int i) { return i % 3 == 0; };
        QVERIFY(m_session->start({}, 2));
        QVERIFY(until(State::Measured));
        QVERIFY(!m_session->compliance());
        QVERIFY2(m_session->problem().startsWith(u"squeeze 1: "_s), qPrintable(m_session->problem()));
        QVERIFY(!m_session->accept());
        QVERIFY(!storedChain());
    }
};

GRIPSCOPE_TEST(FrameSessionTest)
#include "frame_session_test.moc"
