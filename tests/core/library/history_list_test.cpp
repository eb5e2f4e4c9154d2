// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"
#include "core/library/records/history_list.h"
#include "core/library/verification/library_verification.h"
#include "core/session/library/history_document.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/many_inspections.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

using Numbers = std::vector<qint64>;

constexpr int many = 115'000; // five stretches and a part of a sixth

Numbers numbersAt(const Library& library, const HistoryList& list, qint64 first, qint64 count)
{
    Numbers numbers;
    for (const HistoryEntry& entry : valueOf(library.historyPage(list, first, count)))
        numbers.push_back(entry.number);
    return numbers;
}

HistoryList goneThrough(const Library& library, const HistoryQuery& query)
{
    HistoryList list = valueOf(library.historyList(query));
    while (!list.through)
        list = valueOf(library.historyStretch(std::move(list)));
    return list;
}

QString keyOf(int number)
{
    return u"g%1"_s.arg(number, 9, 10, QLatin1Char('0'));
}

} // namespace

class HistoryListTest : public QObject {
    Q_OBJECT

    std::unique_ptr<LibraryFolder> m_folder;
    std::unique_ptr<Library> m_library; ///< of `many` inspections, which no test changes

private slots:
    void initTestCase()
    {
        m_folder = std::make_unique<LibraryFolder>();
        m_library = m_folder->open();
        addManyInspections(m_folder->file(), many);
    }
    void cleanupTestCase()
    {
        m_library.reset();
        m_folder.reset();
    }
    void aListOfFewKnowsAllItsKeys()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QCOMPARE(valueOf(library->historyList({})).rows, 0);
        addManyInspections(folder.file(), 40);
        const HistoryList list = valueOf(library->historyList({}));
        QVERIFY(!list.walked && !list.cut && list.counted && list.through);
        QCOMPARE(list.rows, 40);
        QCOMPARE(list.keys.at(0), keyOf(40));
        QVERIFY(list.counts == valueOf(library->historyCounts({})));
        QCOMPARE(numbersAt(*library, list, 38, 200), Numbers({2, 1}));
        QCOMPARE(valueOf(library->historyRow(list, keyOf(30))), std::optional<qint64>(10));
    }
    void aListOfManyIsWalkedFromAnyPlace()
    {
        HistoryList list = valueOf(m_library->historyList({}));
        QVERIFY(list.walked && list.counted && list.keys.empty());
        QCOMPARE(list.rows, many);
        QCOMPARE(numbersAt(*m_library, list, 0, 3), Numbers({115'000, 114'999, 114'998}));
        QCOMPARE(numbersAt(*m_library, list, 45'000, 2), Numbers({70'000, 69'999}));
        QCOMPARE(numbersAt(*m_library, list, 85'000, 2), Numbers({30'000, 29'999})); // nearer to the end
        QCOMPARE(numbersAt(*m_library, list, many - 2, 200), Numbers({2, 1}));
        QVERIFY(numbersAt(*m_library, list, many, 200).empty());
        QCOMPARE(valueOf(m_library->historyRow(list, keyOf(70'000))), std::optional<qint64>(45'000));
        QVERIFY(!valueOf(m_library->historyRow(list, u"none"_s)));
        list = goneThrough(*m_library, {});
        QCOMPARE(list.marks.size(), std::size_t(many / HistoryList::openStretch));
        QCOMPARE(numbersAt(*m_library, list, 60'000, 2), Numbers({55'000, 54'999}));
        QCOMPARE(numbersAt(*m_library, list, 100'000, 1), Numbers({15'000}));
        QCOMPARE(valueOf(m_library->historyRow(list, keyOf(15'000))), std::optional<qint64>(100'000));
        const HistoryList up = valueOf(m_library->historyList({.descending = false}));
        QCOMPARE(numbersAt(*m_library, up, 0, 2), Numbers({1, 2}));
        QCOMPARE(numbersAt(*m_library, up, 100'000, 2), Numbers({100'001, 100'002}));
        QCOMPARE(valueOf(m_library->historyRow(up, keyOf(100'001))), std::optional<qint64>(100'000));
    }
    void whatTheTalliesKnowIsCountedAtOnce()
    {
        const HistoryQuery query{.outcome = InspectionOutcome::AsExpected};
        HistoryList list = valueOf(m_library->historyList(query));
        QVERIFY(list.walked && list.counted && !list.through); // the way is still to be marked
        QVERIFY(list.counts.asExpected > qint64(HistoryList::mostCollected));
        QCOMPARE(list.rows, list.counts.asExpected);
        const Numbers before = numbersAt(*m_library, list, 60'000, 3);
        const HistoryCounts counts = list.counts;
        while (!list.through)
            list = valueOf(m_library->historyStretch(std::move(list)));
        QVERIFY(!list.marks.empty());
        QVERIFY(list.counts == counts && list.passed == counts); // one by one they are as many
        QCOMPARE(numbersAt(*m_library, list, 60'000, 3), before);
    }
    void theTalliesCountAsAllRowsDo()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        valueOf(library->addGrasp(aGrasp(type)));
        addManyInspections(folder.file(), 300);
        RawDatabase raw(folder.file());
        raw.run(u"UPDATE inspections SET validity = 'suspect' WHERE number % 9 = 0"_s);
        valueOf(library->addInspection(anInspection())); // makes a tally
        for (const qint64 number : {7, 9, 10, 14})
            valueOf(library->voidInspection(number, u"twice"_s, u"Ada"_s));
        for (HistoryQuery query : {HistoryQuery(), HistoryQuery{.kind = SqueezeKind::Inspection},
                                   HistoryQuery{.kind = SqueezeKind::Enrollment},
                                   HistoryQuery{.outcome = InspectionOutcome::OtherType},
                                   HistoryQuery{.type = u"A"_s}, HistoryQuery{.expected = u"A"_s}}) {
            const HistoryCounts tallied = valueOf(library->historyCounts(query));
            query.from = QDateTime(QDate(2000, 1, 1), QTime(0, 0), Qt::UTC); // which they do not know
            QVERIFY(tallied == valueOf(library->historyCounts(query)));
        }
        QCOMPARE(valueOf(library->historyCounts({})).voided, 4);
        QCOMPARE(valueOf(library->historyCounts({})).enrolled, 1);
    }
    void aPeriodIsWalkedFromItsOwnEnds()
    {
        const QDateTime start(QDate(2024, 1, 1), QTime(0, 0), Qt::UTC); // number n: n minutes later
        for (const bool descending : {true, false}) {
            const HistoryQuery query{.from = start.addSecs(60 * 30'000),
                                     .to = start.addSecs(60 * 90'000),
                                     .descending = descending};
            const HistoryList list = goneThrough(*m_library, query);
            QVERIFY(list.walked && list.rows == 60'000);
            const Numbers ends = descending ? Numbers({89'999, 30'000}) : Numbers({30'000, 89'999});
            QCOMPARE(numbersAt(*m_library, list, 0, 1), Numbers({ends[0]}));
            QCOMPARE(numbersAt(*m_library, list, 45'000, 1), Numbers({descending ? 44'999 : 75'000}));
            QCOMPARE(numbersAt(*m_library, list, 59'999, 9), Numbers({ends[1]}));
        }
    }
    void anotherFilterIsCountedStretchByStretch()
    {
        const HistoryQuery query{.operatorName = u"Ada"_s}; // every other one
        HistoryList list = valueOf(m_library->historyList(query));
        QVERIFY(list.walked && !list.counted && !list.through);
        QCOMPARE(list.rows, qint64(HistoryList::mostCollected));
        QCOMPARE(numbersAt(*m_library, list, 0, 2), Numbers({115'000, 114'998}));
        const auto goOn = [&](int stretches) {
            for (int i = 0; i < stretches; ++i)
                list = valueOf(m_library->historyStretch(std::move(list)));
        };
        goOn(1);
        QCOMPARE(list.rows, qint64(HistoryList::mostCollected)); // so many were known before
        goOn(2);
        QCOMPARE(list.rows, 3 * HistoryList::stretch / 2);
        QVERIFY(!list.counted);
        QCOMPARE(numbersAt(*m_library, list, 25'000, 1), Numbers({65'000}));
        goOn(3);
        QVERIFY(list.counted && list.through);
        QCOMPARE(list.rows, many / 2);
        QVERIFY(list.counts == valueOf(m_library->historyCounts(query)));
        QCOMPARE(numbersAt(*m_library, list, 30'000, 2), Numbers({55'000, 54'998}));
        QCOMPARE(numbersAt(*m_library, list, many / 2 - 1, 200), Numbers({2}));
        QCOMPARE(valueOf(m_library->historyRow(list, keyOf(55'000))), std::optional<qint64>(30'000));
        QVERIFY(!valueOf(m_library->historyRow(list, keyOf(55'001)))); // Bob's
    }
    void whatComesLaterIsNotInTheList()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 25'000);
        const HistoryList list = valueOf(library->historyList({}));
        const HistoryList up = valueOf(library->historyList({.descending = false}));
        const QString later = valueOf(library->addInspection(anInspection())).graspId;
        QCOMPARE(numbersAt(*library, list, 0, 1), Numbers({25'000}));
        QCOMPARE(numbersAt(*library, list, 24'999, 5), Numbers({1}));
        QCOMPARE(numbersAt(*library, up, 24'999, 5), Numbers({25'000}));
        QVERIFY(!valueOf(library->historyRow(list, later)));
    }
    void whatIsStoredLaterOfAnEarlierTimeIsNotInIt()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 25'000);
        const HistoryList list = valueOf(library->historyList({}));
        QVERIFY(list.walked);
        const HistoryList up = valueOf(library->historyList({.descending = false}));
        NewInspection waited = anInspection();
        waited.grasp.recorded = QDateTime(QDate(2023, 1, 1), QTime(8, 0), Qt::UTC);
        const QString key = valueOf(library->addInspection(waited)).graspId;
        QCOMPARE(numbersAt(*library, list, 24'998, 5), Numbers({2, 1}));
        QCOMPARE(numbersAt(*library, up, 0, 2), Numbers({1, 2}));
        QVERIFY(!valueOf(library->historyRow(list, key)));
        QCOMPARE(valueOf(library->historyRow(up, keyOf(3))), std::optional<qint64>(2));
        QCOMPARE(valueOf(library->historyList({})).rows, 25'001);
    }
    void inAnotherOrderOfManyTheNewestStand()
    {
        HistoryQuery query{.order = HistoryColumn::Stiffness}; // as the number
        const HistoryList down = valueOf(m_library->historyList(query));
        QVERIFY(down.cut && !down.walked && down.counted);
        QCOMPARE(down.rows, qint64(HistoryList::mostCollected));
        QCOMPARE(down.counts.total(), many);
        QCOMPARE(numbersAt(*m_library, down, 0, 2), Numbers({115'000, 114'999}));
        query.descending = false;
        QCOMPARE(numbersAt(*m_library, valueOf(m_library->historyList(query)), 0, 1), Numbers({95'001}));
        query.order = HistoryColumn::Number; // upwards the oldest
        const HistoryList up = valueOf(m_library->historyList(query));
        QCOMPARE(numbersAt(*m_library, up, 0, 1), Numbers({1}));
        QCOMPARE(numbersAt(*m_library, up, up.rows - 1, 1), Numbers({20'000}));
        query.operatorName = u"Bob"_s;
        const HistoryList bobs = goneThrough(*m_library, query);
        QVERIFY(bobs.cut && bobs.counted);
        QCOMPARE(bobs.rows, qint64(HistoryList::mostCollected));
        QCOMPARE(bobs.counts.total(), many / 2);
    }
    void aSearchFindsTheSameByIndexesAsInEveryRow()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString type = valueOf(library->addType(u"Lantern"_s, {}, u"N"_s, u"m"_s)).id;
        NewGrasp grasp = aGrasp(type);
        grasp.part = u"part_9"_s;
        valueOf(library->addGrasp(grasp));
        NewInspection inspection = anInspection();
        inspection.partNumber = u"SN 100%"_s;
        inspection.batchId = valueOf(library->beginBatch({u"Lot 77"_s, 2, {}, u"Ada"_s})).id;
        valueOf(library->addInspection(inspection));
        RawDatabase(folder.file()).run(u"UPDATE inspections SET number = 1000"_s); // out of the way
        addManyInspections(folder.file(), 600);
        for (const QString& text :
             {u"bob"_s, u"7"_s, u"12"_s, u"gripper 0002"_s, u"B"_s, u"FILE 59"_s, u"lantern"_s, u"_9"_s,
              u"100%"_s, u"sn"_s, u"lot"_s, u"nothing"_s, u"_"_s, u"!"_s})
            for (const QString& operatorName : {u""_s, u"Ada"_s}) {
                const HistoryQuery query{.text = text, .operatorName = operatorName};
                const HistoryKeys rows = valueOf(library->historyKeys(query));
                const HistoryList list = valueOf(library->historyList(query));
                QVERIFY2(list.counted && list.rows == qint64(rows.size()), qPrintable(text));
                QVERIFY2(list.keys.part(0, 1000) == rows.part(0, 1000), qPrintable(text));
            }
    }
    void aSearchThatFindsManyIsWalked()
    {
        const HistoryList bobs = goneThrough(*m_library, {.text = u"bOB"_s});
        QVERIFY(bobs.walked);
        QCOMPARE(bobs.rows, many / 2);
        QCOMPARE(numbersAt(*m_library, bobs, 10'000, 2), Numbers({94'999, 94'997}));
        const HistoryList one = valueOf(m_library->historyList({.text = u"FILE 99990"_s}));
        QVERIFY(one.counted && !one.walked);
        QCOMPARE(numbersAt(*m_library, one, 0, 200), Numbers({99'990}));
        // It names squeezes, and the other filter leaves none of them.
        const HistoryList none =
            valueOf(m_library->historyList({.text = u"FILE 99990"_s, .operatorName = u"Bob"_s}));
        QVERIFY(none.counted && none.rows == 0);
    }
    void ofManyPointsEverySoManyThIsRead()
    {
        const HistoryPoints all = valueOf(m_library->historyPoints(valueOf(m_library->historyList({}))));
        QCOMPARE(all.oneIn, 6); // 115,000 in 20,000 rounded up
        QCOMPARE(all.points.size(), std::size_t(many / 6));
        QCOMPARE(all.keys.at(0), keyOf(6));
        QVERIFY(std::is_sorted(
            all.points.begin(), all.points.end(),
            [](const HistoryPoint& a, const HistoryPoint& b) { return a.time_ms < b.time_ms; }));
        const HistoryQuery unknown{.outcome = InspectionOutcome::Unknown};
        const HistoryPoints few = valueOf(m_library->historyPoints(goneThrough(*m_library, unknown)));
        QCOMPARE(few.oneIn, 1);
        QCOMPARE(few.points.size(), std::size_t(many / 10));
    }
    void anExportOfManyHoldsAll()
    {
        const HistoryQuery query{.operatorName = u"Ada"_s,
                                 .from = QDateTime(QDate(2024, 2, 20), QTime(0, 0), Qt::UTC)};
        const auto wanted = valueOf(m_library->historyCounts(query)).total();
        QVERIFY(wanted > qint64(HistoryList::mostCollected));
        HistoryDocument document(query, HistoryFormat::Csv);
        QByteArray text;
        while (!document.ended())
            text += valueOf(document.next(*m_library));
        QCOMPARE(text.count('\n'), wanted + 1);
        QCOMPARE(qint64(document.written()), wanted);
        QVERIFY(text.mid(text.indexOf('\n') + 1).startsWith("115000,"));
    }
    void aLibraryOfTheStepBeforeGetsItsIndexes()
    {
        const LibraryFolder folder;
        const auto made = [&] {
            return RawDatabase(folder.file())
                .run(u"SELECT COUNT(*) FROM %1 IN ('grasps_by_operator', "
                     "'grasps_by_device', 'inspections_by_part_number', 'inspections_suspect')"_s.arg(
                         onServer() ? u"pg_class WHERE relname"_s : u"sqlite_master WHERE name"_s))
                .toInt();
        };
        {
            const std::vector<Migration> before = migrationsUpTo(17);
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, before));
        }
        QCOMPARE(made(), 0);
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        QCOMPARE(made(), 4);
        valueOf(library->addInspection(anInspection()));
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
};

GRIPSCOPE_TEST(HistoryListTest)
#include "history_list_test.moc"
