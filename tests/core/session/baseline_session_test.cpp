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
/// What moves where nothing is gripped.
constexpr MassDampingStiffness fingers{0.012, 9, 3000};

/// A drive that no spring holds back and whose weight the preload of 20 N balances: m v' = F - 20 N - b v -
/// Fc s(v), in steps of 1 us, stopped where it would turn and the force is below Fc.
std::vector<double> freeDrive(const std::vector<double>& force)
{
    constexpr double m = 0.5, b = 100, friction = 1, step_s = 1e-6, sampleTime_s = 5e-4;
    double x = 0, v = 0;
    std::vector<double> positions;
    for (const double pushed : force) {
        positions.push_back(x);
        const double push = pushed - 20;
        for (double t = 0; t < sampleTime_s - step_s / 2; t += step_s) {
            const double sign = v != 0 ? std::copysign(1.0, v) : std::copysign(1.0, push);
            const double pull = push - b * v - friction * sign;
            if (v == 0 && pull * sign <= 0)
                continue; // it sticks
            const double next = v + step_s * pull / m;
            v = v != 0 && next * v < 0 ? 0 : next;
            x += step_s * v;
        }
    }
    return positions;
}
} // namespace

class BaselineSessionTest : public QObject, SeriesFixture<BaselineSession> {
    Q_OBJECT
private slots:
    void init()
    {
        makeGripper();
        m_connection->gripper().object = fingers;
        QVERIFY(makeSession());
    }
    void cleanup() { clear(); }

    void theEmptyGripperIsFoundKeptAndTakenOff()
    {
        MeasuringChain known;
        known.forceScaleUncertainty = 0.003; // stays, and so does the lag
        m_connection->gripper().trueLag_s = 1e-6;
        m_connection->session.setMeasuringChain(1e-6, known);
        QVERIFY(m_session->start({}, 3));
        QVERIFY(until(State::Measured));
        const GripperBaseline found = m_session->baseline().value();
        const double truth[] = {fingers.m, fingers.b, fingers.k};
        for (std::size_t i = 0; i < 3; ++i) {
            // Five standard errors of three squeezes whose scatter is estimated from themselves.
            QVERIFY2(std::abs(found.parameters[i] - truth[i]) < 5 * found.standardErrors[i],
                     qPrintable(QString::number(found.parameters[i])));
            QVERIFY(found.standardErrors[i] > 0 && found.standardErrors[i] < 0.05 * truth[i]);
        }
        const GripperFriction friction = m_session->friction().value();
        QVERIFY(friction.value < 4 * friction.standardError);
        QVERIFY(!storedChain());
        QVERIFY(m_session->accept());
        QVERIFY(until(State::Stored));
        QVERIFY(storedChain()->chain.baseline == found);
        QVERIFY(storedChain()->chain.friction == friction);
        QCOMPARE(storedChain()->chain.forceScaleUncertainty, 0.003);
        QCOMPARE(storedChain()->forceLag_s, 1e-6);
        QCOMPARE(storedChain()->operatorName, u"Ada"_s);
        QVERIFY(m_connection->session.measuringChain().baseline == found);

        // A part in these fingers is now found without them.
        const MassDampingStiffness part{0.0396, 43, 9990};
        m_connection->gripper().object = {part.m + fingers.m, part.b + fingers.b, part.k + fingers.k};
        SqueezeJob job(m_connection->session);
        QVERIFY(job.start(Recipe(), 9));
        QVERIFY(pollUntil(
            [&] {
                m_connection->session.poll();
                job.poll();
            },
            [&] { return job.state() == SqueezeJob::State::Done; }));
        const auto object = identify(job.recording()).object();
        QVERIFY(object && std::abs(object->parameters.k / part.k - 1) < 0.01);
        QVERIFY(std::abs(object->parameters.m / part.m - 1) < 0.05);
    }

    void aDriveThatNoSpringHoldsBackHasFrictionAndNoStiffness()
    {
        m_connection->gripper().moves = freeDrive;
        QVERIFY(m_session->start({}, 3));
        QVERIFY(until(State::Measured));
        QVERIFY2(m_session->baseline(), qPrintable(m_session->problem()));
        const GripperBaseline found = *m_session->baseline();
        QCOMPARE(found.parameters[2], 0.0);
        // A thousandth is what steps of 1 us are worth.
        QVERIFY2(std::abs(found.parameters[0] - 0.5) < 5 * found.standardErrors[0] + 5e-4,
                 qPrintable(QString::number(found.parameters[0])));
        QVERIFY(m_session->friction());
        QVERIFY2(std::abs(m_session->friction()->value - 1) < 5 * m_session->friction()->standardError + 1e-3,
                 qPrintable(QString::number(m_session->friction()->value)));
    }

    void aSecondMeasurementIsOfTheWholeAgain()
    {
        MeasuringChain known;
        known.baseline = GripperBaseline{{0.006, 4, 1000}, {1e-4, 0.1, 10}};
        m_connection->session.setMeasuringChain(0, known);
        QVERIFY(m_session->start({}, 2));
        QVERIFY(until(State::Measured));
        QVERIFY(std::abs(m_session->baseline()->parameters[2] / fingers.k - 1) < 0.05);
    }

    void itCanBeTakenAwayAgain()
    {
        QVERIFY(!m_session->remove());
        MeasuringChain known;
        known.frameCompliance = 1e-6;
        known.baseline = GripperBaseline{{0.006, 4, 1000}, {1e-4, 0.1, 10}};
        known.friction = GripperFriction{0.2, 0.01};
        m_connection->session.setMeasuringChain(0, known);
        QVERIFY(m_session->remove());
        QVERIFY(until(State::Stored));
        QVERIFY(!storedChain()->chain.baseline && !storedChain()->chain.friction &&
                storedChain()->chain.frameCompliance == 1e-6);
        QVERIFY(!m_connection->session.measuringChain().baseline);
    }

    void squeezesThatAreNotValidMakeNoBaseline()
    {
        m_connection->gripper().dropSample = [](int i) { return i % 3 == 0; };
        QVERIFY(m_session->start({}, 2));
        QVERIFY(until(State::Measured));
        QVERIFY(!m_session->baseline());
        QVERIFY2(m_session->problem().startsWith(u"squeeze 1: "_s), qPrintable(m_session->problem()));
        QVERIFY(!m_session->accept());
        QVERIFY(!storedChain());
    }

    void whatWasMeasuredOfOneGripperIsNotKeptForAnother()
    {
        QVERIFY(m_session->start({}, 2));
        QVERIFY(until(State::Measured));
        m_connection->gripper().identity.serial = u"F-2"_s;
        m_connection->session.poll();
        QVERIFY(!m_session->accept());
        QVERIFY(!storedChain());
    }
};

GRIPSCOPE_TEST(BaselineSessionTest)
#include "baseline_session_test.moc"
