// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/store/library_fixture.h"
#include "tests/core/store/raw_database.h"
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

/// Inspections 1 to `count` by SQL, since storing them one by one with their recordings would take minutes:
/// every tenth unknown, every other by "Bob", the source a file name with its number.
void fill(const QString& file, int count)
{
    RawDatabase raw(file);
    raw.run(u"BEGIN"_s);
    const QString numbers =
        u"WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < %1) "_s.arg(count);
    raw.run(
        u"INSERT INTO grasps (id, station, recorded_utc, operator_name, source, force_unit, position_unit) "_s +
        numbers + u"SELECT 'g' || i, '', '2024-05-31T12:00:00.000Z', '', 'file ' || i, 'N', 'm' FROM n"_s);
    raw.run(
        u"INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, message, program, m, b, k, iterations) "_s +
        numbers +
        u"SELECT 'e' || i, '', '', 'g' || i, 0, 'oe', 'converged', '', '', 0.04, 43, i, 1 FROM n"_s);
    raw.run(u"INSERT INTO inspections "_s + numbers +
            u"SELECT 'i' || i, '', '2024-05-31T12:00:00.000Z', i, 'g' || i, 'A', CASE WHEN i % 10 = 0 THEN "
            u"'unknown' ELSE "
            "'type' END, CASE WHEN i % 10 = 0 THEN '' ELSE 'A' END, 'A', 1, 1, 14, 500, 0.01, 0.001, 1, "
            "CASE WHEN i % 2 = 0 THEN 'Ada' ELSE 'Bob' END, '{}', '[]' FROM n"_s);
    raw.run(u"COMMIT"_s);
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
        QCOMPARE(found[0].reason, u"First. Second."_s);
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
        RawDatabase(folder.file())
            .run(u"CREATE TRIGGER fail BEFORE INSERT ON inspections BEGIN SELECT RAISE(ABORT, 'no'); END"_s);
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
        QCOMPARE(counts.asExpected, 2); // with nothing expected every type is as expected
        QCOMPARE(counts.otherType, 1);
        QCOMPARE(counts.unknown, 1);
        QCOMPARE(counts.inconclusive, 1);
        QCOMPARE(counts.invalid, 1);
    }
    void newestComeFirstPageByPage()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        fill(folder.file(), 25);
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
    void filtersByVerdictAndText()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        fill(folder.file(), 40);
        HistoryFilter filter;
        filter.verdict = VerdictKind::Unknown;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({40, 30, 20, 10}));
        QCOMPARE(valueOf(library->countInspections(filter)), 4);
        filter.text = u"bob"_s; // case does not matter
        QCOMPARE(valueOf(library->countInspections(filter)), 0);
        filter.verdict.reset();
        QCOMPARE(valueOf(library->countInspections(filter)), 20);
        filter.text = u"file 7"_s;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({7}));
        filter.text.clear();
        QCOMPARE(valueOf(library->countInspections(filter)), 40);
    }
    void signsOfTheSearchLanguageAreOrdinaryText()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        for (const QString& source : {u"50%"_s, u"50_a"_s, u"50!"_s, u"O'Brien"_s, u"ÄÖ"_s}) {
            NewInspection inspection = anInspection();
            inspection.grasp.source = source;
            valueOf(library->addInspection(inspection));
        }
        const auto count = [&](const QString& text) {
            return valueOf(library->countInspections({text, {}, 200, 0}));
        };
        QCOMPARE(count(u"0%"_s), 1);
        QCOMPARE(count(u"0_"_s), 1);
        QCOMPARE(count(u"0!"_s), 1);
        QCOMPARE(count(u"o'b"_s), 1);
        QCOMPARE(count(u"ÄÖ"_s), 1);
        QCOMPARE(count(u"50"_s), 3);
    }
    void ahundredThousandInspectionsArePagedThroughTheirIndexes()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        fill(folder.file(), 100'000);
        HistoryFilter filter;
        filter.limit = 3;
        filter.offset = 99'990;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({10, 9, 8}));
        filter.verdict = VerdictKind::Unknown;
        filter.offset = 9'998;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({20, 10}));
        filter.text = u"FILE 99990"_s;
        filter.offset = 0;
        QCOMPARE(numbersOf(*library, filter), std::vector<qint64>({99'990}));
        QCOMPARE(valueOf(library->inspectionCounts()).total, 100'000);
        QCOMPARE(valueOf(library->inspectionCounts()).unknown, 10'000);
        QCOMPARE(valueOf(library->addInspection(anInspection())).number, 100'001);
    }
    void theQueriesOfAPageScanNoTable()
    {
        const LibraryFolder folder;
        folder.open();
        RawDatabase raw(folder.file());
        for (
            const QString& sql :
            {u"SELECT number FROM inspections ORDER BY number DESC LIMIT 200"_s,
             u"SELECT number FROM inspections WHERE verdict = 'unknown' ORDER BY number DESC LIMIT 200"_s,
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
