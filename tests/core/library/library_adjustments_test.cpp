// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_calibration.h"
#include "core/library/audit/audit_trail.h"
#include "core/library/migrations/migration.h"
#include "core/library/spill/spilled_inspection.h"
#include "core/library/verification/library_verification.h"
#include "core/people/audit_entry.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/people_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/core/library/study_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A type with squeezes of the gripper F-1.
QString enrolOn(Library& library, const QString& serial, const QString& name = u"A"_s)
{
    const QString type = valueOf(library.addType(name, {}, u"N"_s, u"m"_s)).id;
    for (int i = 0; i < 3; ++i) {
        NewGrasp grasp = aGrasp(type, 9980 + 10 * i);
        grasp.recording->provenance[u"serial"_s] = serial;
        valueOf(library.addGrasp(grasp));
    }
    return type;
}

std::vector<AuditEntry> told(Library& library, const QString& action)
{
    std::vector<AuditEntry> found;
    for (const AuditEntry& entry : valueOf(library.auditTrail().entries({})))
        if (entry.action == action)
            found.push_back(entry);
    return found;
}

} // namespace

/// Grippers that are adjusted to types of another.
class LibraryAdjustmentsTest : public QObject {
    Q_OBJECT
private slots:
    void anAdjustmentComesBackBitForBit()
    {
        const LibraryFolder folder;
        const QString id = valueOf(folder.open()->acceptAdjustment(anAdjustment())).id;
        const auto library = folder.open();
        const auto standings = valueOf(library->adjustmentsInForce());
        QCOMPARE(standings.size(), std::size_t(1));
        const AdjustmentRecord& record = standings[0].record;
        QCOMPARE(record.id, id);
        QVERIFY(record.inForce && !record.withdrawn && record.accepted.isValid() &&
                !record.program.isEmpty());
        const NewAdjustment& own = record.adjustment;
        const NewAdjustment wanted = anAdjustment();
        QCOMPARE(own.gripperSerial, wanted.gripperSerial);
        QCOMPARE(own.gripperName, wanted.gripperName);
        QCOMPARE(own.enrolledOn, wanted.enrolledOn);
        QCOMPARE(own.types, wanted.types);
        QCOMPARE(own.squeezes, 10);
        QVERIFY(own.error.value == wanted.error.value);
        QVERIFY(own.error.covariance == wanted.error.covariance);
        QVERIFY(own.error.space == wanted.error.space);
        QCOMPARE(own.error.degreesOfFreedom, 18.0);
        QCOMPARE(own.error.agreement, 0.4);
        QCOMPARE(own.operatorName, u"Ada"_s);
        QCOMPARE(own.reason, u"second line"_s);
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void theNewestOfAGripperReplacesTheOneBefore()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString first = valueOf(library->acceptAdjustment(anAdjustment())).id;
        valueOf(library->acceptAdjustment(anAdjustment(u"F-3"_s)));
        const QString second = valueOf(library->acceptAdjustment(anAdjustment())).id;
        QCOMPARE(valueOf(library->adjustmentsInForce()).size(), std::size_t(2));
        const auto all = valueOf(library->adjustments(10));
        QCOMPARE(all.size(), std::size_t(3));
        QVERIFY(all[0].id == second && all[0].inForce);
        QVERIFY(all[2].id == first && !all[2].inForce && !all[2].withdrawn);
        const auto accepted = told(*library, QString::fromUtf16(audit_action::adjustmentAccepted));
        QCOMPARE(accepted.size(), std::size_t(3));
        QCOMPARE(accepted[0].subject, u"F-2"_s);
        QCOMPARE(accepted[0].reason, u"second line"_s);
        QCOMPARE(accepted[0].person, u"Ada"_s);
        QVERIFY(detailsInWords(accepted[0]).contains(u"5.127"_s)); // exp(0.05) - 1 in percent
        QVERIFY(actionInWords(accepted[0].action) != accepted[0].action);
        // The one that was replaced does not come back when its successor goes.
        valueOf(library->withdrawAdjustment(second, u"calibrated"_s, u"Bo"_s));
        QCOMPARE(valueOf(library->adjustmentsInForce()).size(), std::size_t(1));
    }
    void withdrawnItIsToldAndOver()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString id = valueOf(library->acceptAdjustment(anAdjustment())).id;
        QCOMPARE(library->withdrawAdjustment(id, u" "_s, u"Bo"_s).error().code, ErrorCode::Usage);
        QCOMPARE(library->withdrawAdjustment(u"none"_s, u"x"_s, {}).error().code, ErrorCode::NotFound);
        valueOf(library->withdrawAdjustment(id, u"calibrated"_s, u"Bo"_s));
        valueOf(library->withdrawAdjustment(id, u"again"_s, u"Bo"_s)); // changes nothing
        QVERIFY(valueOf(library->adjustmentsInForce()).empty());
        const AdjustmentRecord record = valueOf(library->adjustments(1)).at(0);
        QVERIFY(record.withdrawn && !record.inForce && record.withdrawnAt.isValid());
        QCOMPARE(record.withdrawnBy, u"Bo"_s);
        QCOMPARE(record.withdrawnReason, u"calibrated"_s);
        const auto ends = told(*library, QString::fromUtf16(audit_action::adjustmentWithdrawn));
        QCOMPARE(ends.size(), std::size_t(1));
        QCOMPARE(ends[0].reason, u"calibrated"_s);
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void onlyASupervisorMay()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        QCOMPARE(library->acceptAdjustment(anAdjustment()).error().code, ErrorCode::Usage);
        library->actAs(people.operatorOf(*library));
        QCOMPARE(library->acceptAdjustment(anAdjustment()).error().code, ErrorCode::Usage);
        QVERIFY(valueOf(library->adjustments(1)).empty());
        library->actAs(people.supervisor(*library));
        const QString id = valueOf(library->acceptAdjustment(anAdjustment())).id;
        QCOMPARE(told(*library, QString::fromUtf16(audit_action::adjustmentAccepted)).at(0).person, u"Sam"_s);
        library->actAs(people.operatorOf(*library));
        QCOMPARE(library->withdrawAdjustment(id, u"x"_s, {}).error().code, ErrorCode::Usage);
        QCOMPARE(valueOf(library->adjustmentsInForce()).size(), std::size_t(1));
    }
    void whatMakesNoSenseIsRefused()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto isRefused = [&](NewAdjustment adjustment) {
            const auto answer = library->acceptAdjustment(adjustment);
            return !answer && answer.error().code == ErrorCode::Usage;
        };
        NewAdjustment adjustment = anAdjustment({});
        QVERIFY(isRefused(adjustment));
        adjustment = anAdjustment();
        adjustment.reason = u" "_s;
        QVERIFY(isRefused(adjustment));
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e3}) {
            adjustment = anAdjustment();
            adjustment.error.value(1) = bad;
            QVERIFY(isRefused(adjustment));
        }
        adjustment = anAdjustment();
        adjustment.error.covariance(1, 1) = -1;
        QVERIFY(isRefused(adjustment));
        adjustment = anAdjustment();
        adjustment.studyId = u"none"_s;
        QVERIFY(!library->acceptAdjustment(adjustment));
        QVERIFY(valueOf(library->adjustments(9)).empty());
    }
    void aTypeOfTheGripperItselfStandsAgainstIt()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        enrolOn(*library, u"F-1"_s);
        const QString own = enrolOn(*library, u"F-2"_s, u"B"_s);
        const auto grippers = valueOf(library->grippersOfTypes());
        QCOMPARE(grippers.value(u"A"_s), QStringList{u"F-1"_s});
        QCOMPARE(grippers.value(u"B"_s), QStringList{u"F-2"_s});
        const auto refused = library->acceptAdjustment(anAdjustment());
        QVERIFY(!refused && refused.error().describe().contains(u"B"_s));
        valueOf(library->retireType(own, {u"Ada"_s, u"moved"_s}));
        valueOf(library->acceptAdjustment(anAdjustment()));
        // Nor is one enrolled there while the adjustment is in force.
        NewGrasp grasp = aGrasp(valueOf(library->findType(u"A"_s))->id);
        grasp.recording->provenance[u"serial"_s] = u"F-2"_s;
        const auto notThere = library->addGrasp(grasp);
        QVERIFY(!notThere && notThere.error().describe().contains(u"F-2"_s));
        valueOf(library->reinstateType(own, {u"Ada"_s, u"back"_s}));
        const auto standing = valueOf(library->adjustmentsInForce()).at(0);
        QCOMPARE(standing.ownTypes, QStringList{u"B"_s});
        QVERIFY(
            described(adjustmentSignals(standing)).join(u' ').contains(u"B was enrolled on this gripper"_s));
    }
    void aLaterCalibrationIsToldOf()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addMeasuringChain({u"F-2"_s, 1e-4, {}, u"Ada"_s, u"measured"_s}));
        QTest::qWait(2); // later by the clock's milliseconds
        valueOf(library->acceptAdjustment(anAdjustment()));
        QVERIFY(!valueOf(library->adjustmentsInForce()).at(0).calibratedSince);
        QTest::qWait(2);
        valueOf(library->addMeasuringChain({u"F-3"_s, 1e-4, {}, u"Ada"_s, u"measured"_s}));
        QVERIFY(!valueOf(library->adjustmentsInForce()).at(0).calibratedSince);
        valueOf(library->addMeasuringChain({u"F-2"_s, 2e-4, {}, u"Ada"_s, u"measured"_s}));
        const auto standing = valueOf(library->adjustmentsInForce()).at(0);
        QVERIFY(standing.calibratedSince);
        QVERIFY(described(adjustmentSignals(standing)).join(u' ').contains(u"older than its calibration"_s));
    }
    void anInspectionKeepsWhichAdjustmentItHad()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewInspection inspection = anInspection();
        inspection.adjustmentId = valueOf(library->acceptAdjustment(anAdjustment())).id;
        inspection.grasp.recording->provenance[u"serial"_s] = u"F-2"_s;
        inspection.id = u"0190-key"_s;
        qint64 memory = 100'000'000; // as it comes out of the spill file
        const NewInspection spilled = valueOf(unpackInspection(valueOf(packInspection(inspection)), memory));
        QCOMPARE(spilled.adjustmentId, inspection.adjustmentId);
        const InspectionRecord record = valueOf(library->addInspection(spilled));
        QCOMPARE(record.adjustmentId, inspection.adjustmentId);
        QCOMPARE(record.gripperSerial, u"F-2"_s);
        QVERIFY(!record.station.isEmpty());
        QVERIFY(valueOf(library->addInspection(anInspection())).adjustmentId.isEmpty());
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void everyEarlierVersionGetsThem_data()
    {
        QTest::addColumn<int>("version");
        for (const Migration& step : migrations()) {
            if (step.name == u"adjustments of grippers"_s)
                break;
            QTest::addRow("version %d", step.version) << step.version;
        }
    }
    void everyEarlierVersionGetsThem()
    {
        QFETCH(int, version);
        const LibraryFolder folder;
        {
            const std::vector<Migration> before = migrationsUpTo(version);
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, before));
            QVERIFY(!valueOf(database->tables()).contains(u"gripper_adjustments"_s));
        }
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        NewInspection inspection = anInspection();
        inspection.adjustmentId = valueOf(library->acceptAdjustment(anAdjustment())).id;
        valueOf(library->addInspection(inspection));
        QCOMPARE(valueOf(library->adjustmentsInForce()).size(), std::size_t(1));
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
};

GRIPSCOPE_TEST(LibraryAdjustmentsTest)
#include "library_adjustments_test.moc"
