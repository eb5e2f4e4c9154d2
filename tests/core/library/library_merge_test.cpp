// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/merge/known_history.h"
#include "core/library/merge/library_merge.h"
#include "core/library/merge/row_taker.h"
#include "core/library/migrations/migration.h"
#include "core/library/plant/plant_state.h"
#include "core/library/sql/statement.h"
#include "core/library/verification/library_verification.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/plant_actions.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QJsonDocument>

#include <algorithm>
#include <set>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A library of its own, open.
struct Station {
    LibraryFolder folder;
    std::unique_ptr<Library> library = folder.open();
    [[nodiscard]] QString file() const { return folder.file(); }
    MergeReport merge(const Station& other) const
    {
        return valueOf(library->mergeLibrary(other.file(), why));
    }
    [[nodiscard]] TypeRecord type(const QString& name) const
    {
        const auto found = valueOf(library->findType(name));
        if (!found)
            qFatal("there is no type %s", qPrintable(name));
        return *found;
    }
};

PlantHistory historyOf(const Station& station)
{
    ReadMeetings read;
    return valueOf(knownHistory(*valueOf(Database::openToRead(station.file())), read));
}

QByteArray computed(const Station& station)
{
    return QJsonDocument(canonicalJson(plantState(historyOf(station)))).toJson();
}

/// The keys of rows of changes, of all stations.
std::set<QString> changeRows(const Station& station)
{
    std::set<QString> rows;
    const PlantHistory history = historyOf(station);
    for (const TypeChange& change : history.types)
        rows.insert(change.stamp.row);
    for (const SqueezeChange& change : history.squeezes)
        rows.insert(change.stamp.row);
    return rows;
}

} // namespace

class LibraryMergeTest : public QObject {
    Q_OBJECT
private slots:
    void allOfTheOtherComesAndTwiceIsOnce()
    {
        const Station here, there;
        static_cast<void>(enrol(*here.library, u"Cola"_s, 2));
        const QString fizz = enrol(*there.library, u"Fizz"_s, 3);
        valueOf(there.library->approveType(fizz, u"Ben"_s));
        for (int i = 0; i < 4; ++i)
            valueOf(there.library->addInspection(anInspection(VerdictKind::Type, u"Fizz"_s)));
        valueOf(here.library->addInspection(anInspection()));
        const MergeReport report = here.merge(there);
        QCOMPARE(report.taken.at(u"types"_s), 1);
        QCOMPARE(report.taken.at(u"inspections"_s), 4);
        QCOMPARE(report.alreadyThere, 0);
        QVERIFY(report.conflicts.empty());
        QVERIFY(here.type(u"Fizz"_s).approved);
        QCOMPARE(here.type(u"Fizz"_s).squeezes, 3);
        QCOMPARE(here.type(u"Cola"_s).squeezes, 2);
        QCOMPARE(valueOf(here.library->inspectionCounts()).total, 5);
        const auto squeezes = valueOf(here.library->grasps(fizz));
        QCOMPARE(valueOf(here.library->recording(squeezes[0].id)),
                 valueOf(there.library->recording(squeezes[0].id)));
        QVERIFY(isWhole(here.file()));

        const QByteArray before = bytesOf(here.file());
        const qint64 version = valueOf(here.library->version());
        const MergeReport again = here.merge(there);
        QCOMPARE(again.rows(), 0);
        QVERIFY(again.alreadyThere > 0);
        QCOMPARE(again.links, 0);
        QCOMPARE(valueOf(here.library->version()), version);
        QVERIFY(isWhole(here.file()));
    }
    void whatCameSinceIsAllThatIsTaken()
    {
        const Station here, there;
        const QString fizz = enrol(*there.library, u"Fizz"_s);
        here.merge(there);
        valueOf(there.library->addInspection(anInspection()));
        valueOf(there.library->addGrasp(aGrasp(fizz)));
        const MergeReport report = here.merge(there);
        QCOMPARE(report.links, 2);
        QCOMPARE(report.taken.at(u"inspections"_s), 1);
        QCOMPARE(report.taken.at(u"grasps"_s), 2);
        QCOMPARE(here.type(u"Fizz"_s).squeezes, 2);
        QVERIFY(isWhole(here.file()));
    }
    void aNumberIsThatOfItsStation()
    {
        const Station here, there;
        const qint64 shift = valueOf(here.library->addInspection(anInspection())).number;
        for (int i = 0; i < 3; ++i)
            valueOf(there.library->addInspection(anInspection()));
        here.merge(there);
        std::set<QString> numbers;
        for (const HistoryEntry& entry :
             valueOf(here.library->historyEntries(valueOf(here.library->historyKeys({})).part(0, 10))))
            numbers.insert(entry.numberText());
        const QString station = stationId();
        const std::set<QString> expected{u"1"_s, station + u"-1"_s, station + u"-2"_s, station + u"-3"_s};
        QCOMPARE(numbers, expected);
        // A shift here has only what was inspected here.
        QCOMPARE(valueOf(here.library->inspectionCounts(shift)).total, 0);
        QCOMPARE(valueOf(here.library->addInspection(anInspection())).number, 5);
        QCOMPARE(valueOf(here.library->inspectionCounts(shift)).total, 1);
    }
    void everyTableOfTheLedgerIsTaken()
    {
        std::set<QString> ledgered, taken;
        for (const LedgeredTable& table : ledgeredTables())
            ledgered.insert(table.name);
        for (const TakenTable& table : takenTables())
            QVERIFY2(taken.insert(table.name).second, qPrintable(table.name));
        QCOMPARE(taken, ledgered);
    }
    /// Each way in turn, until nothing is new for either.
    void meetingEachWayComesToAnEnd()
    {
        const Station one, other;
        static_cast<void>(enrol(*one.library, u"Cola"_s));
        static_cast<void>(enrol(*other.library, u"Fizz"_s));
        one.merge(other);
        other.merge(one);
        QCOMPARE(one.merge(other).rows(), 0); // that it has merged is carried along
        QCOMPARE(other.merge(one).rows(), 0);
        QCOMPARE(one.merge(other).links, 0);
        QCOMPARE(inForce(*one.library), inForce(*other.library));
        QVERIFY(isWhole(one.file()) && isWhole(other.file()));
    }
    void aRowOfEveryTableComesAndIsStillProven()
    {
        const Station here, there;
        fillEveryTable(*there.library);
        const MergeReport report = here.merge(there);
        QVERIFY(report.rows() > 40);
        QVERIFY(isWhole(here.file()));
        const LibraryVerification found = valueOf(verifyLibrary(here.file()));
        QVERIFY(found.merged.size() >= 2); // its own and the one that it has met
        const LibraryVerification origin = valueOf(verifyLibrary(there.file()));
        QCOMPARE(found.mergedRows, origin.rows + origin.mergedRows);
        // People stay where they are: nobody may sign in here who could not before.
        QVERIFY(valueOf(here.library->people().all()).empty());
        const Station third;
        third.merge(here);
        QVERIFY(isWhole(third.file()));
        QCOMPARE(inForce(*third.library), inForce(*here.library));
        QCOMPARE(third.merge(there).rows(), 0);
    }
    void bothNamesAreKeptAndTheConflictIsTold()
    {
        const Station one, other;
        const QString cola = enrol(*one.library, u"Cola"_s);
        other.merge(one);
        valueOf(one.library->renameType(cola, u"Cola small"_s, why));
        static_cast<void>(enrol(*other.library, u"Fizz"_s));
        valueOf(other.library->renameType(cola, u"Cola 330"_s, {u"Ben"_s, u"size"_s}));
        const MergeReport report = one.merge(other);
        QCOMPARE(report.conflicts.size(), std::size_t(1));
        const QString words = inWords(report.conflicts.front());
        for (const QString& word : {u"'Cola 330'"_s, u"Ben"_s, u"'Cola small'"_s, u"Ada"_s})
            QVERIFY2(words.contains(word), qPrintable(words));
        QCOMPARE(one.type(u"Cola 330"_s).id, cola);
        const auto entries = valueOf(one.library->auditTrail().entries({}));
        QCOMPARE(entries.front().action, QString::fromUtf16(audit_action::libraryMerged));
        QVERIFY(detailsInWords(entries.front()).contains(u"Cola small"_s));
        // Until somebody has seen it.
        QCOMPARE(valueOf(one.library->conflicts()).size(), std::size_t(1));
        valueOf(one.library->noteConflictsSeen(valueOf(one.library->conflicts()), why));
        QVERIFY(valueOf(one.library->conflicts()).empty());
        other.merge(one);
        QCOMPARE(valueOf(other.library->conflicts()).size(), std::size_t(1)); // there nobody has
        QVERIFY(isWhole(one.file()) && isWhole(other.file()));
    }
    void typesOfOneNameStayTwoAndInspectionsGoOn()
    {
        const Station one, other;
        static_cast<void>(enrol(*one.library, u"Cola"_s, 2));
        static_cast<void>(enrol(*other.library, u"Cola"_s, 3));
        one.merge(other);
        other.merge(one);
        QCOMPARE(valueOf(one.library->types()).size(), std::size_t(2));
        QCOMPARE(inForce(*one.library), inForce(*other.library));
        QCOMPARE(one.type(u"Cola"_s).squeezes + one.type(u"Cola (%1)"_s.arg(stationId())).squeezes, 5);
        for (const Station* station : {&one, &other})
            valueOf(station->library->addInspection(anInspection()));
        one.merge(other);
        QCOMPARE(valueOf(one.library->inspectionCounts()).total, 2);
        QVERIFY(isWhole(one.file()));
    }
    /// Four histories over two to four libraries, each with its own file; the rule itself is tried on 200 in
    /// PlantStateTest.
    void randomHistoriesEndInTheSameState_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 4; ++seed)
            QTest::addRow("%u", seed) << seed;
    }
    void randomHistoriesEndInTheSameState()
    {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        std::vector<std::unique_ptr<Station>> stations;
        for (unsigned i = 0; i < 2 + random() % 3; ++i)
            stations.push_back(std::make_unique<Station>());
        const auto anyone = [&]() -> Station& { return *stations[random() % stations.size()]; };
        for (int step = 0; step < 24; ++step) {
            Station& station = anyone();
            Station& other = anyone();
            if (random() % 10 == 0 && &station != &other)
                station.merge(other);
            else
                changeSomething(*station.library, random);
        }
        std::set<QString> all;
        for (const auto& station : stations)
            all.merge(changeRows(*station));
        for (int round = 0; round < 2; ++round) {
            std::vector<std::pair<Station*, Station*>> meetings;
            for (const auto& one : stations)
                for (const auto& other : stations)
                    if (one != other)
                        meetings.emplace_back(one.get(), other.get());
            std::shuffle(meetings.begin(), meetings.end(), random);
            for (const auto& [one, other] : meetings)
                one->merge(*other);
        }
        const Station& first = *stations.front();
        for (const auto& station : stations) {
            QCOMPARE(changeRows(*station), all);
            QCOMPARE(computed(*station), computed(first));
            QCOMPARE(inForce(*station->library), inForce(*first.library));
            QVERIFY(isWhole(station->file()));
            for (const auto& other : stations)
                if (station != other)
                    QCOMPARE(station->merge(*other).rows(), 0);
        }
    }
    void aCopyThatWasGoneOnWithIsRefused()
    {
        const Station here;
        static_cast<void>(enrol(*here.library, u"Cola"_s));
        const LibraryFolder copy;
        RawDatabase(here.file()).run(u"PRAGMA wal_checkpoint(TRUNCATE)"_s);
        QVERIFY(QFile::copy(here.file(), copy.file()));
        QCOMPARE(valueOf(here.library->mergeLibrary(copy.file(), why)).rows(),
                 0); // as long as it is but that
        valueOf(copy.open()->addInspection(anInspection()));
        const auto gone = here.library->mergeLibrary(copy.file(), why);
        QVERIFY(!gone);
        QCOMPARE(gone.error().code, ErrorCode::StorageOpen);
        valueOf(here.library->addInspection(anInspection()));
        QVERIFY(!here.library->mergeLibrary(copy.file(), why));
        QVERIFY(isWhole(here.file()));
    }
    void whoMetACopyIsToldSo()
    {
        const Station here, there;
        static_cast<void>(enrol(*here.library, u"Cola"_s));
        const LibraryFolder copy;
        RawDatabase(here.file()).run(u"PRAGMA wal_checkpoint(TRUNCATE)"_s);
        QVERIFY(QFile::copy(here.file(), copy.file()));
        valueOf(here.library->addInspection(anInspection()));
        there.merge(here);
        // An older copy is put back, and the other knows more of it.
        const auto older = copy.open();
        QVERIFY(!older->mergeLibrary(there.file(), why));
        // Both went on differently.
        valueOf(older->addInspection(anInspection(VerdictKind::Unknown)));
        QVERIFY(!there.library->mergeLibrary(copy.file(), why));
    }
    void whatIsDamagedOrForeignIsRefusedAndChangesNothing()
    {
        const Station here, there;
        static_cast<void>(enrol(*there.library, u"Fizz"_s));
        const qint64 links = RawDatabase(here.file()).count(u"ledger"_s);
        RawDatabase(there.file()).run(u"UPDATE types SET name = 'Bizz'"_s);
        const auto damaged = here.library->mergeLibrary(there.file(), why);
        QVERIFY(!damaged);
        QVERIFY(damaged.error().describe().contains(u"library verify"_s));
        QTemporaryDir folder;
        writeBytes(folder.filePath(u"text"_s), "this is no library at all");
        QVERIFY(!here.library->mergeLibrary(folder.filePath(u"text"_s), why));
        QVERIFY(!here.library->mergeLibrary(folder.filePath(u"none"_s), why));
        const auto onServer = here.library->mergeLibrary(u"postgresql://one@db.example/plant"_s, why);
        QVERIFY(!onServer && onServer.error().describe().contains(u"file into file"_s));
        QVERIFY(!here.library->mergeLibrary(here.file(), why));
        QCOMPARE(RawDatabase(here.file()).count(u"ledger"_s), links);
    }
    void anEarlierSchemaIsToBeOpenedOnce()
    {
        const Station here;
        const LibraryFolder old;
        {
            const std::vector<Migration> before = migrationsUpTo(27);
            const auto database = valueOf(Database::open(old.file()));
            valueOf(migrate(*database, before));
            QVERIFY(!valueOf(database->tables()).contains(u"merged_rows"_s));
        }
        QVERIFY(!here.library->mergeLibrary(old.file(), why));
        {
            const auto opened = old.open();
            valueOf(opened->addType(u"Fizz"_s, {}, u"N"_s, u"m"_s));
        }
        QCOMPARE(valueOf(here.library->mergeLibrary(old.file(), why)).taken.at(u"types"_s), 1);
        QVERIFY(isWhole(here.file()));
    }
    void typesThatCannotBeComparedAreRefused()
    {
        const Station here, there;
        static_cast<void>(enrol(*here.library, u"Cola"_s));
        valueOf(there.library->addType(u"Fizz"_s, {}, u"1"_s, u"1"_s));
        const auto merged = here.library->mergeLibrary(there.file(), why);
        QVERIFY(!merged);
        QCOMPARE(merged.error().code, ErrorCode::UnitsDiffer);
        QVERIFY(isWhole(here.file()));
    }
    void aSupervisorIsAskedForWherePeopleAre()
    {
        const Station here, there;
        static_cast<void>(enrol(*there.library, u"Fizz"_s));
        const People people(*here.library);
        QCOMPARE(here.library->mergeLibrary(there.file(), why).error().code, ErrorCode::Usage);
        here.library->actAs(people.operatorOf(*here.library));
        QVERIFY(!here.library->mergeLibrary(there.file(), why));
        here.library->actAs(people.supervisor(*here.library));
        QVERIFY(here.merge(there).rows() > 0);
    }
    void theNewestCalibrationIsInForceWhereverItWasMade()
    {
        const Station here, there;
        const auto calibrate = [](const Station& station, const QString& note) {
            SensorCalibration calibration = aCalibration();
            calibration.note = note;
            valueOf(station.library->addCalibration(calibration));
            QTest::qSleep(2); // the clocks have milliseconds
        };
        const auto inForceAt = [](const Station& station) {
            return valueOf(station.library->calibrationsInForce(u"0001"_s)).force->note;
        };
        calibrate(there, u"first"_s);
        calibrate(here, u"second, not knowing of the first"_s);
        here.merge(there);
        there.merge(here);
        QCOMPARE(inForceAt(here), u"second, not knowing of the first"_s);
        QCOMPARE(inForceAt(there), u"second, not knowing of the first"_s);
        for (const Station* station : {&there, &here, &there}) {
            calibrate(*station, u"again"_s);
            const Station& other = station == &here ? there : here;
            other.merge(*station);
            QCOMPARE(inForceAt(other), u"again"_s);
            calibrate(other, u"last"_s);
            here.merge(there);
            there.merge(here);
            QCOMPARE(inForceAt(here), u"last"_s);
            QCOMPARE(inForceAt(there), u"last"_s);
        }
        QVERIFY(isWhole(here.file()));
        QVERIFY(isWhole(there.file()));
    }
    void whatIsChangedOfAnotherStationIsFound()
    {
        const Station here, there;
        const QString fizz = enrol(*there.library, u"Fizz"_s);
        valueOf(there.library->addInspection(anInspection()));
        valueOf(there.library->renameType(fizz, u"Fizz 330"_s, why));
        here.merge(there);
        QVERIFY(isWhole(here.file()));
        RawDatabase(here.file()).run(u"PRAGMA wal_checkpoint(TRUNCATE)"_s);
        const QByteArray bytes = bytesOf(here.file());
        for (const QString& edit :
             {u"UPDATE merged_rows SET number = number + 1 WHERE is_origin = 1 AND table_code = 13"_s,
              u"UPDATE merged_rows SET is_origin = 0"_s, u"DELETE FROM merged_rows WHERE table_code = 26"_s,
              u"UPDATE merged_rows SET content = REPLACE(content, 'Fizz', 'Bizz')"_s,
              u"DELETE FROM merged_ledger WHERE number = (SELECT MAX(number) FROM merged_ledger)"_s,
              u"UPDATE merged_ledger SET created_utc = '2000' WHERE number = 2"_s,
              u"INSERT INTO merged_rows SELECT 'x', table_code, row_key, number, 0, whole, content FROM "
              "merged_rows"_s}) {
            const LibraryFolder edited;
            writeBytes(edited.file(), bytes);
            RawDatabase(edited.file()).run(edit);
            QVERIFY2(!valueOf(verifyLibrary(edited.file())).whole(), qPrintable(edit));
        }
    }
};

GRIPSCOPE_TEST(LibraryMergeTest)
#include "library_merge_test.moc"
