// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/records/batch.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;

namespace {

const NewBatch ofThree{u"4711"_s, 3, u"A"_s, u"Ada"_s};

qint64 inspect(Library& library, const QString& batchId, VerdictKind kind = VerdictKind::Type,
               const QString& type = u"A"_s)
{
    NewInspection inspection = anInspection(kind, type);
    inspection.batchId = batchId;
    return valueOf(library.addInspection(inspection)).number;
}

} // namespace

/// Parts that are inspected and counted together.
class LibraryBatchesTest : public QObject {
    Q_OBJECT
private slots:
    void onlyPartsAsExpectedCountTowardsABatch()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        inspect(*library, {}); // before it
        const BatchRecord batch = valueOf(library->beginBatch(ofThree));
        QCOMPARE(batch.counts.total, 0);
        inspect(*library, batch.id);
        inspect(*library, batch.id, VerdictKind::Type, u"B"_s);
        inspect(*library, batch.id, VerdictKind::Unknown);
        inspect(*library, batch.id, VerdictKind::Invalid);
        const BatchRecord now = valueOf(library->batchUnderWay()).value();
        QCOMPARE(now.counts.total, 4);
        QCOMPARE(now.counts.asExpected, 1);
        QCOMPARE(now.counts.otherType, 1);
        QCOMPARE(now.counts.unknown, 1);
        QCOMPARE(now.counts.invalid, 1);
        QVERIFY(!now.whole());
        inspect(*library, batch.id);
        inspect(*library, batch.id);
        QVERIFY(valueOf(library->batchUnderWay())->whole());
        QCOMPARE(valueOf(library->inspectionCounts()).total, 7);
    }
    void aBatchGoesOnInTheNextProgram()
    {
        const LibraryFolder folder;
        {
            const auto library = folder.open();
            inspect(*library, valueOf(library->beginBatch(ofThree)).id);
        }
        const auto library = folder.open();
        const BatchRecord batch = valueOf(library->batchUnderWay()).value();
        QCOMPARE(batch.name, u"4711"_s);
        QCOMPARE(batch.target, 3);
        QCOMPARE(batch.expectedType, u"A"_s);
        QCOMPARE(batch.operatorName, u"Ada"_s);
        QVERIFY(batch.begun.isValid() && !batch.ended);
        QCOMPARE(batch.counts.asExpected, 1);
    }
    void anEndIsARowMore()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const BatchRecord batch = valueOf(library->beginBatch(ofThree));
        QVERIFY(valueOf(library->endBatch(batch.id, u"Bob"_s)).ended);
        valueOf(library->endBatch(batch.id, u"Bob"_s)); // again, and nothing is changed
        QVERIFY(!valueOf(library->batchUnderWay()));
        RawDatabase raw(folder.file());
        QCOMPARE(raw.count(u"batch_ends"_s), 1);
        QCOMPARE(raw.run(u"SELECT operator_name FROM batch_ends"_s).toString(), u"Bob"_s);
        valueOf(library->beginBatch(ofThree)); // the next may have the same number
        QCOMPARE(valueOf(library->batches(10)).size(), std::size_t(2));
        QCOMPARE(library->endBatch(u"none"_s, {}).error().code, ErrorCode::NotFound);
    }
    void theAuditTrailTellsOfBothEnds()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const BatchRecord batch = valueOf(library->beginBatch(ofThree));
        inspect(*library, batch.id);
        valueOf(library->endBatch(batch.id, u"Bob"_s));
        valueOf(library->endBatch(batch.id, u"Bob"_s)); // is no end any more
        const auto entries = valueOf(library->auditTrail().entries({{}, u"batch."_s}));
        QCOMPARE(entries.size(), std::size_t(2));
        QCOMPARE(entries[1].action, u"batch.begun"_s);
        QCOMPARE(entries[1].person, u"Ada"_s);
        QCOMPARE(entries[1].subject, u"4711"_s);
        QVERIFY(entries[1].details.contains(u"\"parts\":3"_s));
        QCOMPARE(entries[0].action, u"batch.ended"_s);
        QCOMPARE(entries[0].person, u"Bob"_s);
        QVERIFY(entries[0].details.contains(u"\"squeezes\":1"_s));
        QVERIFY(actionInWords(entries[0].action) != entries[0].action);
    }
    void theHistoryNamesTheBatch()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        inspect(*library, {});
        inspect(*library, valueOf(library->beginBatch(ofThree)).id);
        const auto found = valueOf(library->inspections({}));
        QCOMPARE(found[0].batch, u"4711"_s);
        QCOMPARE(found[1].batch, QString());
    }
    void anInspectionOfNoSuchBatchIsNotStored()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewInspection inspection = anInspection();
        inspection.batchId = u"none"_s;
        QVERIFY(!library->addInspection(inspection));
        QCOMPARE(valueOf(library->inspectionCounts()).total, 0);
        RawDatabase raw(folder.file());
        QCOMPARE(raw.count(u"grasps"_s), 0);
    }
    void whatIsNoBatchIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<qint64>("target");
        QTest::newRow("no name") << u"  "_s << qint64(3);
        QTest::newRow("a long name") << QString(longestBatchName + 1, u'x') << qint64(3);
        QTest::newRow("no parts") << u"4711"_s << qint64(0);
        QTest::newRow("too many parts") << u"4711"_s << largestBatch + 1;
    }
    void whatIsNoBatchIsRefused()
    {
        QFETCH(QString, name);
        QFETCH(qint64, target);
        const LibraryFolder folder;
        const auto library = folder.open();
        QCOMPARE(library->beginBatch({name, target, {}, {}}).error().code, ErrorCode::Usage);
        QVERIFY(!valueOf(library->batchUnderWay()));
    }
    void twoAtOnceAreRefused()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->beginBatch(ofThree));
        const auto second = library->beginBatch({u"4712"_s, 5, {}, {}});
        QCOMPARE(second.error().code, ErrorCode::Usage);
        QVERIFY(second.error().describe().contains(u"4711"_s));
    }
    void theNewestIsTheOneThatBeganLastWhateverTheClockSays()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->endBatch(valueOf(library->beginBatch(ofThree)).id, {}));
        // The clock was a lifetime ahead, and is right again.
        RawDatabase(folder.file()).run(u"UPDATE batches SET begun_utc = '2099-01-01T00:00:00.000Z'"_s);
        NewBatch next = ofThree;
        next.name = u"4712"_s;
        valueOf(library->beginBatch(next));
        QCOMPARE(valueOf(library->batches(2)).front().name, u"4712"_s);
        QCOMPARE(valueOf(library->batchUnderWay())->name, u"4712"_s);
    }
    void anotherStationsBatchIsNotOurs()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->beginBatch(ofThree));
        RawDatabase(folder.file()).run(u"UPDATE batches SET station = 'elsewhere'"_s);
        QVERIFY(!valueOf(library->batchUnderWay()));
        valueOf(library->beginBatch({u"4712"_s, 5, {}, {}}));
    }
};

GRIPSCOPE_TEST(LibraryBatchesTest)
#include "library_batches_test.moc"
