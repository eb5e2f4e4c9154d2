// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/history.h"
#include "core/library/records/yield.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/many_inspections.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

std::vector<qint64> numbersOf(const Library& library, const HistoryFilter& filter)
{
    std::vector<qint64> numbers;
    for (const InspectionRecord& inspection : valueOf(library.inspections(filter)))
        numbers.push_back(inspection.number);
    return numbers;
}

} // namespace

class LibraryHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void anInspectionComesBackAsItWasStored()
    {
        const LibraryFolder folder;
        const NewInspection inspection = anInspection();
        const InspectionRecord added = valueOf(folder.open()->addInspection(inspection));
        const auto library = folder.open();
        const auto found = valueOf(library->inspections({}));
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].id, added.id);
        QCOMPARE(found[0].graspId, added.graspId);
        QCOMPARE(found[0].number, 1);
        QVERIFY(found[0].verdict == VerdictKind::Type);
        QCOMPARE(found[0].type, u"A"_s);
        QCOMPARE(found[0].nearest, u"A"_s);
        QCOMPARE(found[0].expectedType, u"A"_s);
        QCOMPARE(found[0].reason.describe(), u"First. Second."_s);
        QCOMPARE(found[0].operatorName, u"Ada"_s);
        QCOMPARE(*found[0].posterior, 0.75);
        QCOMPARE(*found[0].distance, 1.5);
        QCOMPARE(*found[0].gate, 14.25);
        QVERIFY(*found[0].parameters == *inspection.grasp.estimates[0].parameters);
        QCOMPARE(found[0].forceUnit, u"N"_s);
        QCOMPARE(found[0].seconds, 1.0);
        QVERIFY(valueOf(library->recording(added.graspId)) == *inspection.grasp.recording);
        QVERIFY(valueOf(library->enrolledSqueezes()).empty()); // it belongs to no type
    }
    void anInvalidSqueezeWithoutEstimatesIsStoredToo()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewInspection inspection = anInspection(VerdictKind::Invalid, {});
        inspection.grasp.estimates.clear();
        inspection.verdict = {};
        const InspectionRecord added = valueOf(library->addInspection(inspection));
        QVERIFY(added.verdict == VerdictKind::Invalid);
        QVERIFY(!added.parameters && !added.posterior && !added.distance && !added.gate);
    }
    void anInspectionThatFailsLeavesNoSqueezeBehind()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        takeNoMoreThan(0, u"inspections"_s, folder.file());
        QCOMPARE(library->addInspection(anInspection()).error().code, ErrorCode::StorageFailed);
        RawDatabase raw(folder.file());
        for (const QString& table : {u"grasps"_s, u"recordings"_s, u"estimates"_s, u"documents"_s})
            QCOMPARE(raw.count(table), 0);
    }
    void countsAreByOutcome()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto add = [&](VerdictKind kind, const QString& type, const QString& expected) {
            NewInspection inspection = anInspection(kind, type);
            inspection.expectedType = expected;
            valueOf(library->addInspection(inspection));
        };
        add(VerdictKind::Type, u"A"_s, u"A"_s);
        add(VerdictKind::Type, u"B"_s, u"A"_s);
        add(VerdictKind::Type, u"B"_s, {});
        add(VerdictKind::Unknown, u"A"_s, u"A"_s);
        add(VerdictKind::Inconclusive, u"A"_s, u"A"_s);
        add(VerdictKind::Invalid, u"A"_s, u"A"_s);
        const InspectionCounts counts = valueOf(library->inspectionCounts());
        QCOMPARE(counts.total, 6);
        QCOMPARE(counts.asExpected, 2); // a known type counts there with nothing expected
        QCOMPARE(counts.knownType, 1);  // and is told apart
        QCOMPARE(counts.otherType, 1);
        QCOMPARE(counts.unknown, 1);
        QCOMPARE(counts.inconclusive, 1);
        QCOMPARE(counts.invalid, 1);
        add(VerdictKind::Unknown, u"A"_s, {});
        add(VerdictKind::Inconclusive, u"A"_s, {});
        const InspectionCounts now = valueOf(library->inspectionCounts());
        QCOMPARE(now.knownType, 1);
        QCOMPARE(now.unasked, 2);
        const HistoryCounts history = valueOf(library->historyCounts({}));
        QCOMPARE(history.knownType, 1);
        QCOMPARE(history.unasked, 2);
        QVERIFY(yieldOf(history) == yieldOf(now));
        valueOf(library->voidInspection(3, u"twice"_s, u"Ada"_s));
        QCOMPARE(valueOf(library->inspectionCounts()).knownType, 0);
        QCOMPARE(valueOf(library->historyCounts({})).unasked, 1);
    }
    void newestComeFirstPageByPage()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 25);
        HistoryFilter filter;
        filter.limit = 10;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({25, 24, 23, 22, 21, 20, 19, 18, 17, 16}));
        filter.offset = 20;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({5, 4, 3, 2, 1}));
        filter.offset = 25;
        QVERIFY(numbersOf(*library, filter).empty());
        filter.limit = -5;
        QVERIFY(numbersOf(*library, filter).empty());
    }
    void ahundredThousandInspectionsArePagedThroughTheirIndexes()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 100'000);
        HistoryFilter filter;
        filter.limit = 3;
        filter.offset = 99'990;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({10, 9, 8}));
        QCOMPARE(valueOf(library->inspectionCounts()).total, 100'000);
        QCOMPARE(valueOf(library->inspectionCounts()).unknown, 10'000);
        QCOMPARE(valueOf(library->addInspection(anInspection())).number, 100'001);
    }
    void countingAllIsCountingThoseSinceTheLastTally()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 5000);
        valueOf(library->addInspection(anInspection(VerdictKind::Unknown))); // 5001, which makes a tally
        valueOf(library->addInspection(anInspection()));
        valueOf(library->addInspection(anInspection(VerdictKind::Invalid)));
        RawDatabase raw(folder.file());
        QCOMPARE(raw.column(u"SELECT DISTINCT up_to FROM inspection_tallies"_s), QStringList{u"5001"_s});
        QCOMPARE(raw.run(u"SELECT SUM(n) FROM inspection_tallies"_s).toLongLong(), 5001);
        const InspectionCounts counts = valueOf(library->inspectionCounts());
        QCOMPARE(counts.total, 5003);
        QCOMPARE(counts.unknown, 500 + 1);
        QCOMPARE(counts.invalid, 1);
        QCOMPARE(counts.otherType, 5000 / 7 - 5000 / 70); // every seventh, unless it is a tenth
        QCOMPARE(counts.expected[u"A"_s].squeezes, 5002);
        // The next, in time.
        raw.run(u"UPDATE inspections SET number = number + 100000 WHERE number > 5001"_s);
        valueOf(library->addInspection(anInspection()));
        QCOMPARE(raw.run(u"SELECT MAX(up_to) FROM inspection_tallies"_s).toLongLong(), 105004);
        QCOMPARE(valueOf(library->inspectionCounts()).total, 5004);
        // Those before the tally are not looked at: it holds them, whatever the rows say now.
        raw.run(u"UPDATE inspections SET verdict = 'invalid' WHERE number <= 100"_s);
        QCOMPARE(valueOf(library->inspectionCounts()).invalid, 1);
        for (const QString& step :
             raw.column(u"EXPLAIN QUERY PLAN SELECT verdict FROM inspections WHERE number > (SELECT "
                        "COALESCE(MAX(up_to), 0) FROM inspection_tallies)"_s))
            QVERIFY2(step.contains(u"INDEX"_s) || step.contains(u"SUBQUERY"_s), qPrintable(step));
    }
    void theQueriesOfAPageScanNoTable()
    {
        const LibraryFolder folder;
        folder.open();
        RawDatabase raw(folder.file());
        for (
            const QString& sql :
            {u"SELECT number FROM inspections ORDER BY number DESC LIMIT 200"_s,
             u"SELECT id FROM grasps ORDER BY recorded_utc DESC, id DESC"_s,
             u"SELECT id FROM grasps WHERE type_id IS NULL ORDER BY recorded_utc DESC, id DESC"_s,
             u"SELECT COALESCE(MAX(number), 0) + 1 FROM inspections"_s,
             u"SELECT verdict, expected_type, type_name, COUNT(*) FROM inspections GROUP BY verdict, expected_type, type_name"_s,
             u"SELECT id FROM grasps WHERE type_id = 'x' ORDER BY recorded_utc, id"_s})
            for (const QString& step : raw.column(u"EXPLAIN QUERY PLAN "_s + sql))
                QVERIFY2(step.contains(u"INDEX"_s) && !step.contains(u"B-TREE"_s),
                         qPrintable(sql + u": "_s + step));
    }
};

GRIPSCOPE_TEST(LibraryHistoryTest)
#include "library_history_test.moc"
