// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/migrations/migration.h"
#include "core/library/records/batch.h"
#include "core/library/verification/library_verification.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/many_inspections.h"
#include "tests/core/library/process_inspections.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;

/// What control charts read of a library.
class LibraryProcessTest : public QObject {
    Q_OBJECT
private slots:
    void inspectionsOfATypeComeInTheirOrder()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QDateTime start(QDate(2026, 5, 4), QTime(8, 0), Qt::UTC);
        for (int i = 0; i < 6; ++i)
            addPart(*library, {.parameters = {0.04, 43, 9990.0 + i},
                               .type = i == 2 ? u"B"_s : u"A"_s,
                               .operatorName = i % 2 == 0 ? u"Ada"_s : u"Bob"_s,
                               .time = start.addSecs(i)});
        NewInspection unknown = inspectionOf({});
        unknown.verdict.kind = VerdictKind::Unknown;
        unknown.verdict.type.clear();
        valueOf(library->addInspection(unknown));
        valueOf(library->voidInspection(4, u"dropped"_s, u"Ada"_s));
        const ProcessValues values = valuesOf(*library, {.type = u"A"_s});
        QCOMPARE(values.numbers.toVector(), (std::vector<qint64>{1, 2, 5, 6}));
        QCOMPARE(values.quantities[2].toVector(), (std::vector<double>{9990, 9991, 9994, 9995}));
        QCOMPARE(values.quantities[0].toVector(), std::vector<double>(4, 0.04));
        QCOMPARE(values.times_ms[1], start.addSecs(1).toMSecsSinceEpoch());
        QCOMPARE(values.operatorNames, (QStringList{u"Ada"_s, u"Bob"_s}));
        QCOMPARE(values.operators.toVector(), (std::vector<std::uint32_t>{0, 1, 0, 1}));
        QCOMPARE(values.stationNames.size(), 1);
        QVERIFY(values.si && !values.unitsDiffer);
        QVERIFY(valuesOf(*library, {.type = u"C"_s}).empty());
        QCOMPARE(valuesOf(*library, {.type = u"A"_s, .after = 2}).numbers.toVector(),
                 (std::vector<qint64>{5, 6}));
        QVERIFY(valuesOf(*library, {.type = u"A"_s, .after = 7}).empty());
        QCOMPARE(valuesOf(*library, {.type = u"A"_s, .newest = 2}).numbers.toVector(),
                 (std::vector<qint64>{6}));
        QVERIFY(!valueOf(library->inspectedSqueeze(5)).isEmpty());
        QVERIFY(library->inspectedSqueeze(99).error().code == ErrorCode::NotFound);
    }
    void batchesAreNamed()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const BatchRecord batch = valueOf(library->beginBatch({u"4711"_s, 10, {}, u"Ada"_s}));
        addPart(*library, {});
        addPart(*library, {.batchId = batch.id});
        const ProcessValues values = valuesOf(*library, {.type = u"A"_s});
        QCOMPARE(values.batchNames, (QStringList{QString(), u"4711"_s}));
        QCOMPARE(values.batches.toVector(), (std::vector<std::uint32_t>{0, 1}));
    }
    void unitsAreBroughtTogether()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addPart(*library, {});
        addPart(*library, {.parameters = {0.00004, 0.043, 9.99}, .positionUnit = u"mm"_s});
        ProcessValues values = valuesOf(*library, {.type = u"A"_s});
        QVERIFY(values.si && !values.unitsDiffer);
        QVERIFY(std::abs(values.quantities[2][1] - 9990) < 1e-9);
        addPart(*library, {.positionUnit = u"steps"_s});
        values = valuesOf(*library, {.type = u"A"_s});
        QVERIFY(!values.si && values.unitsDiffer);
    }
    void whatIsNotDeterminedIsNoNumber()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addPart(*library, {});
        RawDatabase(folder.file()).run(u"UPDATE estimates SET m = NULL"_s);
        const ProcessValues values = valuesOf(*library, {.type = u"A"_s});
        QVERIFY(std::isnan(values.quantities[0][0]));
        QCOMPARE(values.quantities[2][0], 9990.0);
    }
    /// 120,000 take three stretches; filtered by a gripper a third is left.
    void stretchesGoOnWhereTheLastEnded()
    {
        const LibraryFolder folder;
        folder.open();
        constexpr int count = 120'000;
        addManyInspections(folder.file(), count);
        const auto library = folder.open();
        ProcessValues values;
        ProcessPlace place;
        int stretches = 0;
        double share = 0;
        while (!place.through) {
            place = valueOf(library->processStretch({.type = u"A"_s}, place, values));
            QVERIFY(place.share() > share || place.through);
            share = place.share();
            ++stretches;
        }
        QCOMPARE(stretches, 2); // of A alone: three of four
        qint64 expected = 0;
        for (int i = 1; i <= count; ++i)
            expected += i % 10 != 0 && i % 7 != 0 ? 1 : 0;
        QCOMPARE(qint64(values.size()), expected);
        QVERIFY(std::is_sorted(values.numbers.begin(), values.numbers.end()));
        QCOMPARE(values.quantities[2].back(), double(values.numbers.back()));
        const ProcessValues some = valuesOf(*library, {.type = u"A"_s, .gripper = u"Gripper 0001"_s});
        QVERIFY(some.size() > values.size() / 4 && some.size() < values.size() / 2);
        QVERIFY(std::ranges::all_of(some.numbers, [](qint64 number) { return number % 3 == 1; }));
    }
    /// Few of many: their estimates are stepped to, looked up, or on a server stepped to over several
    /// fetches.
    void aRareTypesEstimatesAreFoundAmongMany()
    {
        const LibraryFolder folder;
        folder.open();
        addManyInspections(folder.file(), 5000);
        {
            RawDatabase raw(folder.file());
            raw.run(u"UPDATE inspections SET type_name = 'C', verdict = 'type' WHERE number IN (5, 12, 22, "
                    u"400, 812, "
                    "2900, 5000)"_s);
            raw.run(u"DELETE FROM estimates WHERE k = 812"_s);
        }
        const ProcessValues values = valuesOf(*folder.open(), {.type = u"C"_s});
        QCOMPARE(values.numbers.toVector(), (std::vector<qint64>{5, 12, 22, 400, 812, 2900, 5000}));
        for (std::size_t i = 0; i < values.size(); ++i)
            if (values.numbers[i] == 812)
                QVERIFY(std::isnan(values.quantities[2][i]));
            else
                QCOMPARE(values.quantities[2][i], double(values.numbers[i]));
    }
    void limitsStayFixedUntilTheyAreReleased()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QVERIFY(!valueOf(library->processLimits(u"A"_s)));
        valueOf(library->fixProcessLimits(u"A"_s, u"{\"k\":1}"_s, u"Ada"_s));
        valueOf(library->fixProcessLimits(u"B"_s, u"{\"k\":2}"_s, u"Ada"_s));
        const auto fixed = valueOf(library->processLimits(u"A"_s));
        QVERIFY(fixed && fixed->limits == u"{\"k\":1}"_s && fixed->operatorName == u"Ada"_s &&
                fixed->fixed.isValid());
        valueOf(library->fixProcessLimits(u"A"_s, {}, u"Bob"_s));
        QVERIFY(valueOf(library->processLimits(u"A"_s))->limits.isEmpty());
        QVERIFY(library->fixProcessLimits({}, {}, {}).error().code == ErrorCode::Usage);
    }
    void whoFixesThemAndWhatIsInTheAuditTrail()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->fixProcessLimits(
            u"A"_s, u"{\"kind\":\"i-mr\",\"first\":1,\"last\":100,\"count\":98,\"k\":[9990.5,20.25]}"_s,
            u"Ada"_s));
        const AuditEntry told = valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(told.action, QString::fromUtf16(audit_action::chartsFixed));
        QCOMPARE(told.subject, u"A"_s);
        QCOMPARE(told.person, u"Ada"_s);
        QCOMPARE(detailsInWords(told), u"chart: i-mr; from inspection: 1; inspections: 98; "
                                       "k: centre: 9990.5; sigma: 20.25; to inspection: 100"_s);
        valueOf(library->fixProcessLimits(u"A"_s, {}, u"Bob"_s));
        QCOMPARE(valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front().action,
                 QString::fromUtf16(audit_action::chartsReleased));
    }
    /// By whichever name it was inspected; a name that another type has taken since is that one's.
    void aTypeIsFollowedThroughItsNames()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        // What is stored in one millisecond would be before and after a change alike.
        const auto add = [&library](const QString& type) {
            QTest::qSleep(3);
            addPart(*library, {.type = type, .time = QDateTime::currentDateTimeUtc()});
            QTest::qSleep(3);
        };
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        add(u"A"_s);
        add(u"A"_s);
        valueOf(library->fixProcessLimits(u"A"_s, u"{\"k\":1}"_s, u"Ada"_s));
        valueOf(library->renameType(type.id, u"Cola"_s, {u"Ada"_s, u"clearer"_s}));
        add(u"Cola"_s);
        add(u"A"_s); // was under way
        add(u"B"_s);
        const std::vector<qint64> own{1, 2, 3, 4};
        QCOMPARE(valuesOf(*library, {.type = u"Cola"_s}).numbers.toVector(), own);
        QCOMPARE(valuesOf(*library, {.type = u"A"_s}).numbers.toVector(), own);
        QCOMPARE(valuesOf(*library, {.type = u"Cola"_s, .after = 2}).numbers.toVector(),
                 (std::vector<qint64>{3, 4}));
        QCOMPARE(valueOf(library->processLimits(u"Cola"_s))->limits, u"{\"k\":1}"_s);
        QCOMPARE(valueOf(library->typeNamesToday({u"A"_s, u"B"_s, u"Cola"_s})),
                 (QStringList{u"Cola"_s, u"B"_s}));
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        add(u"A"_s);
        add(u"Cola"_s);
        QCOMPARE(valuesOf(*library, {.type = u"Cola"_s}).numbers.toVector(),
                 (std::vector<qint64>{1, 2, 3, 4, 7}));
        QCOMPARE(valuesOf(*library, {.type = u"A"_s}).numbers.toVector(), (std::vector<qint64>{6}));
        QVERIFY(!valueOf(library->processLimits(u"A"_s)));
        QCOMPARE(valueOf(library->processLimits(u"Cola"_s))->limits, u"{\"k\":1}"_s);
    }
    void everyEarlierSchemaGetsThem_data()
    {
        QTest::addColumn<int>("version");
        for (int version = 12; version < migrations().back().version; ++version) // earlier: LibraryOpenTest
            QTest::addRow("version %d", version) << version;
    }
    void everyEarlierSchemaGetsThem()
    {
        QFETCH(int, version);
        const LibraryFolder folder;
        const std::vector<Migration> before = migrationsUpTo(version);
        valueOf(migrate(*valueOf(Database::open(folder.file())), before));
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        addPart(*library, {});
        QCOMPARE(valuesOf(*library, {.type = u"A"_s}).size(), std::size_t(1));
        valueOf(library->fixProcessLimits(u"A"_s, u"{}"_s, u"Ada"_s));
        QVERIFY(valueOf(library->processLimits(u"A"_s)));
    }
};

GRIPSCOPE_TEST(LibraryProcessTest)
#include "library_process_test.moc"
