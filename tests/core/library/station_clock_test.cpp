// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/migrations/migration.h"
#include "core/library/records/history.h"
#include "core/library/sql/database.h"
#include "core/library/verification/library_verification.h"
#include "core/session/library/history_document.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QJsonObject>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

const QDateTime someMorning(QDate(2026, 1, 2), QTime(8, 30), Qt::UTC);

NewInspection inspectedAt(const QDateTime& time, std::optional<qint64> offset_s = {})
{
    NewInspection inspection = anInspection();
    inspection.grasp.recorded = time;
    inspection.grasp.utcOffset_s = offset_s;
    return inspection;
}

HistoryEntry newestEntry(const Library& library)
{
    const HistoryKeys keys = valueOf(library.historyKeys({.order = HistoryColumn::Number}));
    return valueOf(library.historyEntries(keys.part(0, 1))).at(0);
}

qint64 stepsTold(Library& library)
{
    return valueOf(library.auditTrail().count({{}, u"clock.back"_s}));
}

} // namespace

/// By which clock a squeeze was recorded, and whether that clock is to be trusted.
class StationClockTest : public QObject {
    Q_OBJECT
private slots:
    void theOffsetOfThenIsKept()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(inspectedAt(someMorning, 19'800))); // five and a half hours
        const HistoryEntry entry = newestEntry(*library);
        QCOMPARE(entry.time, someMorning);
        QCOMPARE(entry.timeThere().time(), QTime(14, 0));
        QVERIFY(!entry.station.isEmpty() && !entry.clockSetBack);
        const QJsonObject json = toJson(entry);
        QCOMPARE(json[u"time_local"].toString(), u"2026-01-02T14:00:00.000+05:30"_s);
        QCOMPARE(json[u"time_utc"].toString(), u"2026-01-02T08:30:00.000Z"_s);
        QCOMPARE(json[u"station"].toString(), entry.station);
        QVERIFY(json.contains(u"clock_set_back"_s) && json[u"clock_set_back"].isNull());
        QVERIFY(toCsv({entry}).contains(",2026-01-02T14:00:00.000+05:30,"));
    }
    void whatIsRecordedNowHasTheOffsetOfNow()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(anInspection()));
        const HistoryEntry entry = newestEntry(*library);
        QCOMPARE(entry.utcOffset_s, std::optional(qint64(entry.time.toLocalTime().offsetFromUtc())));
    }
    void whatWasNotRecordedIsNotGuessed()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(inspectedAt(someMorning)));
        const HistoryEntry entry = newestEntry(*library);
        QVERIFY(!entry.utcOffset_s && !entry.timeThere().isValid());
        QVERIFY(toJson(entry)[u"time_local"].isNull());
    }
    void aClockThatIsSetBackBetweenInspectionsIsToldOnce()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QDateTime wrong = QDateTime::currentDateTimeUtc().addDays(10);
        valueOf(library->addInspection(inspectedAt(wrong)));
        QVERIFY(!newestEntry(*library).clockSetBack); // nobody knows yet
        valueOf(library->addInspection(anInspection()));
        QCOMPARE(stepsTold(*library), 1);
        valueOf(library->addInspection(anInspection()));
        QCOMPARE(stepsTold(*library), 1);
        const auto entries = valueOf(library->historyEntries(valueOf(library->historyKeys({})).part(0, 10)));
        QCOMPARE(entries.size(), std::size_t(3));
        QVERIFY(entries[0].number == 1 && entries[0].clockSetBack);
        // These are of the clock that was set right, whatever it shows until the wrong time comes.
        QVERIFY(!entries[1].clockSetBack && !entries[2].clockSetBack);
        QCOMPARE(entries[0].clockSetBack->from.toSecsSinceEpoch(), wrong.toSecsSinceEpoch());
        const QString interval = toJson(entries[0])[u"clock_set_back"].toString();
        QCOMPARE(interval.count(u'/'), 1);
        QVERIFY(interval.endsWith(wrong.toString(Qt::ISODateWithMs)));
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void enrolledSqueezesOfBeforeAreMarkedToo()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        NewGrasp ahead = aGrasp(type);
        ahead.recorded = QDateTime::currentDateTimeUtc().addDays(10);
        valueOf(library->addGrasp(ahead));
        valueOf(library->addInspection(inspectedAt(ahead.recorded)));
        valueOf(library->addGrasp(aGrasp(type))); // its entry in the trail tells
        QCOMPARE(stepsTold(*library), 1);
        const auto entries = valueOf(library->historyEntries(
            valueOf(library->historyKeys({.kind = SqueezeKind::Enrollment})).part(0, 10)));
        QCOMPARE(entries.size(), std::size_t(2));
        QVERIFY(entries[0].clockSetBack && !entries[1].clockSetBack);
    }
    void aTimeServersCorrectionIsNoStep()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(inspectedAt(QDateTime::currentDateTimeUtc().addSecs(20))));
        valueOf(library->addInspection(anInspection()));
        QCOMPARE(stepsTold(*library), 0);
    }
    void anotherStationsTimesAreLeftAlone()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(inspectedAt(QDateTime::currentDateTimeUtc().addDays(10))));
        RawDatabase(folder.file()).run(u"UPDATE inspections SET station = 'elsewhere'"_s);
        RawDatabase(folder.file()).run(u"UPDATE grasps SET station = 'elsewhere'"_s);
        valueOf(library->addInspection(anInspection()));
        QCOMPARE(stepsTold(*library), 0);
    }
    void aLibraryOfTheStepBeforeGetsIt()
    {
        const LibraryFolder folder;
        {
            const std::vector<Migration> before = migrationsUpTo(18);
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, before));
            valueOf(
                database->execute(u"INSERT INTO grasps (id, station, recorded_utc, operator_name, source, "
                                  "force_unit, position_unit) VALUES ('g', 's', "
                                  "'2026-01-02T08:30:00.000Z', 'Ada', 'virtual:', 'N', 'm')"_s,
                                  u"prepare"_s));
        }
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        QVERIFY(!newestEntry(*library).utcOffset_s);
        valueOf(library->addInspection(inspectedAt(someMorning, 3600)));
        QCOMPARE(newestEntry(*library).utcOffset_s, std::optional(qint64(3600)));
    }
};

GRIPSCOPE_TEST(StationClockTest)
#include "station_clock_test.moc"
