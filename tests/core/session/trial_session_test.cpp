// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/session/enroll/trial_session.h"
#include "tests/core/session/inspection_run.h"
#include "tests/core/session/series_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

/// What a squeeze would be called, before anybody approves.
class TrialSessionTest : public QObject, SeriesFixture<TrialSession> {
    Q_OBJECT
    /// All that a trial must not touch.
    struct Standing {
        qint64 version = 0, entries = 0, inspections = 0;
        bool approved = true;
        friend bool operator==(const Standing&, const Standing&) = default;
    };
    Standing standing()
    {
        return ask<Standing>([](Library& library) -> Expected<Standing> {
            Standing now;
            now.version = library.version().value();
            now.entries = library.auditTrail().count({}).value();
            now.inspections = library.inspectionCounts().value().total;
            now.approved = library.findType(u"C"_s).value()->approved;
            return now;
        });
    }

private slots:
    void init()
    {
        makeGripper();
        enrolTypes(m_folder->filePath(u"library.db"_s), {{u"A"_s, canA}, {u"C"_s, canC}}, 5);
        auto dropping = m_library->run<void>([](Library& library) {
            const QString type = library.findType(u"C"_s).value()->id;
            return library.dropGrasp(library.grasps(type).value().front().id, u"slipped"_s, u"Ada"_s);
        });
        QVERIFY(dropping.get());
        m_connection->gripper().object = canC;
        QVERIFY(makeSession());
    }
    void cleanup() { clear(); }

    void aTypeThatIsNotApprovedCanBeTried()
    {
        const Standing before = standing();
        QVERIFY(!before.approved);
        QVERIFY(m_session->start(u"C"_s, {}, {}));
        QVERIFY(until(State::Measured));
        QVERIFY(m_session->verdict());
        QVERIFY(m_session->verdict()->kind == VerdictKind::Type);
        QCOMPARE(m_session->verdict()->type, u"C"_s);
        QVERIFY(standing() == before);
    }
    void othersThatAreNotApprovedTakeNoPart()
    {
        QVERIFY(m_session->start(u"A"_s, {}, {}));
        QVERIFY(until(State::Measured));
        QVERIFY(m_session->verdict()->type != u"C"_s);
        QVERIFY(!m_session->verdict()->posterior.contains(u"C"_s));
    }
    void aTrialThatIsRefusedChangesNothingOfTheOneUnderWay()
    {
        QVERIFY(m_session->start(u"C"_s, {}, {}));
        QVERIFY(!m_session->start(u"A"_s, {}, {}));
        QVERIFY(until(State::Measured));
        QCOMPARE(m_session->verdict()->type, u"C"_s); // which is a candidate in its own trial alone
    }
    void anotherTrialForgetsTheOneBefore()
    {
        QVERIFY(m_session->start(u"C"_s, {}, {}));
        QVERIFY(until(State::Measured));
        QVERIFY(m_session->start(u"C"_s, {}, {}));
        QVERIFY(!m_session->verdict());
        m_session->cancel();
        QVERIFY(m_session->state() == State::Failed);
    }
};

GRIPSCOPE_TEST(TrialSessionTest)
#include "trial_session_test.moc"
