// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_record.h"
#include "core/library/audit/audit_trail.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

ReferenceObject spring(double stiffness = 10000.0 / 3)
{
    ReferenceObject reference;
    reference.gripperSerial = u"0001"_s;
    reference.name = u"Spring S-12"_s;
    reference.certificate = u"F-0815"_s;
    reference.stated[1] = ReferenceQuantity{4.1, 0.01, 0.4};
    reference.stated[2] = ReferenceQuantity{stiffness, 5, 100};
    reference.bias_N = 15;
    reference.peak_N = 7.5;
    reference.squeezes = 4;
    reference.intervalHours = 8;
    reference.operatorName = u"Ada"_s;
    return reference;
}

ReferenceStanding inUse(const Library& library)
{
    return *valueOf(library.calibrationsInForce(u"0001"_s)).reference;
}

ReferenceCheck check(const Library& library, CheckVerdict verdict)
{
    ReferenceCheck check;
    check.gripperSerial = u"0001"_s;
    check.referenceId = inUse(library).reference.id;
    check.verdict = verdict;
    if (verdict == CheckVerdict::NotValid)
        check.obstacle = u"squeeze 1: 12 samples are missing"_s;
    else
        check.measured[2] = MeasuredQuantity{1e4 / 3.1, 0.1};
    check.squeezes = 4;
    check.operatorName = u"Mai"_s;
    return check;
}

} // namespace

class ReferenceStoreTest : public QObject {
    Q_OBJECT
private slots:
    void anObjectComesBackToTheLastDigitAndTheNewestIsInUse()
    {
        const LibraryFolder folder;
        QVERIFY(!valueOf(folder.open()->calibrationsInForce(u"0001"_s)).reference);
        QVERIFY(folder.open()->addReferenceObject(spring()));
        const auto library = folder.open();
        QVERIFY(static_cast<const ReferenceObject&>(inUse(*library).reference) == spring());
        QVERIFY(!inUse(*library).last);
        QVERIFY(library->addReferenceObject(spring(5000)));
        QVERIFY(static_cast<const ReferenceObject&>(inUse(*library).reference) == spring(5000));
        QVERIFY(!valueOf(library->calibrationsInForce(u"0002"_s)).reference);
    }

    void theAuditTrailTellsOfChecks()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QVERIFY(library->addReferenceObject(spring()));
        const auto newest = [&] { return valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front(); };
        QVERIFY(library->addReferenceCheck(check(*library, CheckVerdict::Failed)));
        QCOMPARE(newest().action, u"calibration.checked"_s);
        QCOMPARE(newest().subject, u"0001"_s);
        QCOMPARE(newest().person, u"Mai"_s);
        QCOMPARE(detailsInWords(newest()), u"reference: Spring S-12; squeezes: 4; verdict: failed"_s);
        QVERIFY(actionInWords(newest().action) != newest().action);
        QVERIFY(library->addReferenceCheck(check(*library, CheckVerdict::NotValid)));
        QCOMPARE(newest().reason, u"squeeze 1: 12 samples are missing"_s);
    }

    void checksAreKeptWithWhatTheyWereMadeOn()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QVERIFY(library->addReferenceObject(spring()));
        const ReferenceCheck first = check(*library, CheckVerdict::Passed);
        QVERIFY(library->addReferenceCheck(first));
        QVERIFY(library->addReferenceCheck(check(*library, CheckVerdict::NotValid)));
        const auto kept = valueOf(library->referenceChecks(u"0001"_s, 10));
        QCOMPARE(kept.size(), std::size_t(2));
        QVERIFY(kept[0].verdict == CheckVerdict::NotValid);
        QCOMPARE(kept[0].obstacle, u"squeeze 1: 12 samples are missing"_s);
        QVERIFY(kept[1].measured == first.measured && kept[1].squeezes == 4);
        QVERIFY(static_cast<const ReferenceObject&>(kept[1].reference) == spring());
        // One that was not valid says nothing of the gripper: the one before it stands.
        QCOMPARE(inUse(*library).last->id, kept[1].id);
        QVERIFY(library->addReferenceCheck(check(*library, CheckVerdict::Failed)));
        QVERIFY(inUse(*library).last->verdict == CheckVerdict::Failed);
        QCOMPARE(valueOf(library->referenceChecks(u"0001"_s, 1)).size(), std::size_t(1));
        // Another object was not checked on yet.
        QVERIFY(library->addReferenceObject(spring(5000)));
        QVERIFY(!inUse(*library).last);
        QCOMPARE(valueOf(library->referenceChecks(u"0001"_s, 10)).size(), std::size_t(3));
    }

    void whatCannotBeUsedLaterIsRefused()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        ReferenceObject nameless = spring();
        nameless.name.clear();
        QVERIFY(!library->addReferenceObject(nameless));
        ReferenceObject anyones = spring();
        anyones.gripperSerial.clear();
        QVERIFY(!library->addReferenceObject(anyones));
        QVERIFY(library->addReferenceObject(spring()));
        ReferenceCheck lost = check(*library, CheckVerdict::Passed);
        lost.referenceId = u"no such"_s;
        QCOMPARE(library->addReferenceCheck(lost).error().code, ErrorCode::NotFound);
        ReferenceCheck endless = check(*library, CheckVerdict::Passed);
        endless.measured[2]->value = INFINITY;
        QCOMPARE(library->addReferenceCheck(endless).error().code, ErrorCode::Usage);
        QVERIFY(valueOf(library->referenceChecks(u"0001"_s, 10)).empty());
    }

    void aVerdictThatIsDamagedIsToldAndNotGuessed()
    {
        GRIPSCOPE_OF_FILES_ALONE("a server holds every row to its constraints")
        const LibraryFolder folder;
        {
            const auto library = folder.open();
            QVERIFY(library->addReferenceObject(spring()));
            QVERIFY(library->addReferenceCheck(check(*library, CheckVerdict::Passed)));
        }
        RawDatabase raw(folder.file());
        raw.run(u"PRAGMA ignore_check_constraints = ON"_s);
        raw.run(u"UPDATE reference_checks SET verdict = 'perhaps'"_s);
        const auto read = folder.open()->referenceChecks(u"0001"_s, 10);
        QVERIFY(!read && read.error().code == ErrorCode::StorageCorrupt);
    }
};

GRIPSCOPE_TEST(ReferenceStoreTest)
#include "reference_store_test.moc"
