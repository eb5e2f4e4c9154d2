// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_facts.h"
#include "core/session/calibrate/measuring_sessions.h"
#include "tests/core/session/series_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class ReferenceCheckSessionTest : public QObject, SeriesFixture<ReferenceCheckSession> {
    Q_OBJECT
    void state(double stiffness, double tolerance = 300)
    {
        ReferenceObject reference;
        reference.gripperSerial = u"F-1"_s;
        reference.name = u"Spring S-12"_s;
        reference.stated[2] = ReferenceQuantity{stiffness, 20, tolerance};
        reference.squeezes = 2;
        m_connection->session.setCalibrations(ask<CalibrationsInForce>([reference](Library& library) {
            return library.addReferenceObject(reference).and_then(
                [&] { return library.calibrationsInForce(reference.gripperSerial); });
        }));
    }
    std::vector<ReferenceCheckRecord> stored()
    {
        using Checks = std::vector<ReferenceCheckRecord>;
        return ask<Checks>([](Library& library) { return library.referenceChecks(u"F-1"_s, 9); });
    }
    /// The check `calibration` of a squeeze as the gripper stands now.
    ValidityCheck verdictOnTheCalibration()
    {
        SqueezeJob job(m_connection->session);
        if (!job.start(Recipe(), 5) || !pollUntil(
                                           [&] {
                                               m_connection->session.poll();
                                               job.poll();
                                           },
                                           [&] { return job.state() == SqueezeJob::State::Done; }))
            qFatal("no squeeze");
        const Validity validity = identify(job.recording()).validity;
        for (const ValidityCheck& check : validity.checks)
            if (check.id == u"calibration"_s)
                return check;
        qFatal("no such check");
    }

private slots:
    void init()
    {
        makeGripper(); // on a can of 9,990 N/m
        QVERIFY(makeSession());
    }
    void cleanup() { clear(); }

    void aGripperInOrderPassesAndItsMeasurementsAreNotSuspect()
    {
        QVERIFY(!m_session->start()); // on what?
        state(9990);
        QVERIFY(!verdictOnTheCalibration().ok); // due: never made
        QVERIFY(m_session->start());
        QVERIFY(until(State::Stored));
        const auto kept = stored();
        QCOMPARE(kept.size(), std::size_t(1));
        QVERIFY2(kept[0].verdict == CheckVerdict::Passed, qPrintable(kept[0].obstacle));
        QCOMPARE(kept[0].operatorName, u"Ada"_s);
        QCOMPARE(kept[0].squeezes, 2);
        QVERIFY(std::abs(kept[0].measured[2]->value / 9990 - 1) < 0.01);
        QVERIFY(kept[0].measured[2]->standardUncertainty > 0);
        QVERIFY(kept[0].measured == m_session->check()->measured);
        QVERIFY(verdictOnTheCalibration().ok);
    }

    void aGripperThatIsOffFailsAndItsMeasurementsAreSuspect()
    {
        state(9000);
        QVERIFY(m_session->start());
        QVERIFY(until(State::Stored));
        QVERIFY(stored().at(0).verdict == CheckVerdict::Failed);
        const ValidityCheck check = verdictOnTheCalibration();
        QVERIFY(!check.ok && !check.decisive);
        QVERIFY2(check.message.describe().contains(u"failed"_s) &&
                     check.message.describe().contains(u"Spring S-12"_s),
                 qPrintable(check.message.describe()));
    }

    void aBadMeasurementSaysNothingOfTheGripper()
    {
        state(9990);
        m_connection->gripper().dropSample = [](int i) { return i % 3 == 0; };
        QVERIFY(m_session->start());
        QVERIFY(until(State::Stored));
        QVERIFY(stored().at(0).verdict == CheckVerdict::NotValid);
        QVERIFY(stored().at(0).obstacle.contains(u"missing"_s) && !stored().at(0).measured[2]);
        QVERIFY(!m_connection->session.calibration().reference()->last);
        m_connection->gripper().dropSample = {};
        QVERIFY(verdictOnTheCalibration().message.describe().contains(u"was due"_s));
    }

    void whatIsMeasuredTooCoarselyIsNotPassed()
    {
        state(9990, 40); // the stated uncertainty alone fills it
        m_connection->gripper().noise_m = 2e-4;
        QVERIFY(m_session->start());
        QVERIFY(until(State::Stored));
        QVERIFY(stored().at(0).verdict != CheckVerdict::Passed);
    }

    void aSqueezeNamesTheCheckItRestsOn()
    {
        state(9990);
        QMap<QString, QString> provenance;
        noteReferenceCheck(provenance, *m_connection->session.calibration().reference(),
                           QDateTime::currentDateTimeUtc());
        QCOMPARE(referenceCheckFact(provenance)->status, CheckStatus::Due);
        QCOMPARE(referenceCheckFact(provenance)->words.describe(), u"never on Spring S-12"_s);
        QVERIFY(!referenceCheckFact({}));
    }
};

GRIPSCOPE_TEST(ReferenceCheckSessionTest)
#include "reference_check_session_test.moc"
