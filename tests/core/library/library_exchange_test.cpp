// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/exchange/library_exchange.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/merge/known_history.h"
#include "core/library/merge/library_merge.h"
#include "core/library/merge/meeting_table.h"
#include "core/library/sql/statement.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/linked_station.h"
#include "tests/core/library/plant_actions.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <set>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// The keys of a library's inspections, each as often as it is there.
std::multiset<QString> inspectionKeys(const QString& place)
{
    std::multiset<QString> keys;
    const auto database = valueOf(Database::open(place));
    Statement query(*database, u"be read"_s, u"SELECT id FROM inspections"_s);
    valueOf(query.forEach([&](Statement& row) { keys.insert(row.takeText()); }));
    return keys;
}

} // namespace

class LibraryExchangeTest : public QObject {
    Q_OBJECT
private slots:
    void whatAStationWritesIsAtTheServerOnce()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation station;
        const QString cola = enrol(*station.library, u"Cola"_s, 3);
        for (int i = 0; i < 40; ++i)
            valueOf(station.library->addInspection(anInspection(VerdictKind::Type, u"Cola"_s)));
        qint64 links = 0, waiting = std::numeric_limits<qint64>::max();
        for (ExchangeStep taken; !taken.inStep;) {
            taken = station.step(*plant, 7); // batches that end anywhere
            QVERIFY(taken.delivered.waiting < waiting || taken.inStep);
            waiting = taken.delivered.waiting;
            links += taken.delivered.links;
        }
        QVERIFY(links >= 44);
        QCOMPARE(inspectionKeys(server.file()), inspectionKeys(station.file()));
        QCOMPARE(valueOf(plant->inspectionCounts()).total, 40);
        QCOMPARE(inForce(*plant), inForce(*station.library));
        const QString squeeze = valueOf(plant->grasps(cola))[0].id;
        QCOMPARE(valueOf(plant->recording(squeeze)), valueOf(station.library->recording(squeeze)));
        const ExchangeStep again = station.step(*plant);
        QCOMPARE(again.delivered.links, 0);
        QVERIFY(again.inStep);
        QVERIFY(isWhole(server.file()));
        QVERIFY(isWhole(station.file()));
    }
    void typesComeToAllStationsAndInspectionsToTheServerAlone()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation one, other;
        const QString cola = enrol(*one.library, u"Cola"_s, 3);
        valueOf(one.library->approveType(cola, u"Ada"_s));
        valueOf(one.library->addCalibration(aCalibration()));
        valueOf(one.library->addInspection(anInspection()));
        valueOf(other.library->addInspection(anInspection()));
        QVERIFY(one.bringInStep(*plant).empty());
        QVERIFY(other.bringInStep(*plant).empty());
        QCOMPARE(inForce(*other.library), inForce(*one.library));
        QVERIFY(valueOf(other.library->findType(u"Cola"_s))->approved);
        const QString squeeze = valueOf(one.library->grasps(cola))[0].id;
        QCOMPARE(valueOf(other.library->recording(squeeze)), valueOf(one.library->recording(squeeze)));
        QCOMPARE(valueOf(other.library->calibrations(u"0001"_s, 10)).size(), std::size_t(1));
        QCOMPARE(valueOf(other.library->inspectionCounts()).total, 1);
        QCOMPARE(valueOf(plant->inspectionCounts()).total, 2);

        // What one changes next comes to the other as a change of this state.
        valueOf(other.library->renameType(cola, u"Cola 330"_s, why));
        QVERIFY(other.bringInStep(*plant).empty());
        QVERIFY(one.bringInStep(*plant).empty());
        QVERIFY(valueOf(one.library->findType(u"Cola 330"_s)));
        for (const QString& place : {server.file(), one.file(), other.file()})
            QVERIFY(isWhole(place));
    }
    void whatTwoDecideApartIsOneStateAndTold()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation one, other;
        const QString cola = enrol(*one.library, u"Cola"_s, 2);
        one.bringInStep(*plant);
        other.bringInStep(*plant);
        valueOf(one.library->renameType(cola, u"Cola small"_s, why));
        valueOf(other.library->renameType(cola, u"Cola 330"_s, why));
        one.bringInStep(*plant);
        const auto told = other.bringInStep(*plant);
        QCOMPARE(told.size(), std::size_t(1));
        QVERIFY(told[0].kind == PlantConflict::Kind::Name);
        one.bringInStep(*plant);
        QCOMPARE(inForce(*one.library), inForce(*plant));
        QCOMPARE(inForce(*other.library), inForce(*plant));
        valueOf(plant->noteConflictsSeen(told, {u"Ada"_s, {}}));
        QVERIFY(valueOf(plant->conflicts()).empty());
    }
    void randomStationsEndInOneState()
    {
        constexpr int histories = 6;
        for (unsigned seed = 1; seed <= histories; ++seed) {
            std::mt19937 random(seed);
            const LibraryFolder server;
            const auto plant = server.open();
            std::array<LinkedStation, 3> stations;
            for (int i = 0; i < 25; ++i) {
                LinkedStation& station = stations[random() % stations.size()];
                if (random() % 5 == 0)
                    station.bringInStep(*plant);
                else if (random() % 4 == 0)
                    valueOf(station.library->addInspection(anInspection()));
                else
                    changeSomething(*station.library, random);
            }
            for (int round = 0; round < 2; ++round)
                for (LinkedStation& station : stations)
                    station.bringInStep(*plant);
            std::multiset<QString> inspections;
            for (LinkedStation& station : stations) {
                QVERIFY2(inForce(*station.library) == inForce(*plant), qPrintable(QString::number(seed)));
                inspections.merge(inspectionKeys(station.file()));
                QVERIFY(isWhole(station.file()));
            }
            QCOMPARE(inspectionKeys(server.file()), inspections);
            QVERIFY(isWhole(server.file()));
        }
    }
    /// With fifty stations and a year of changes, all that was seen, each time, would be a gigabyte.
    void whatWasSeenIsKeptOnce()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        std::array<LinkedStation, 3> stations;
        const QString cola = enrol(*stations[0].library, u"Cola"_s);
        for (int i = 0; i < 4; ++i)
            for (LinkedStation& station : stations) {
                station.bringInStep(*plant);
                Recipe recipe;
                recipe.peak_N = 5.0 + (++m_revisions % 7);
                valueOf(station.library->reviseType(cola, recipe, why));
                station.bringInStep(*plant);
            }
        std::vector<QString> places{server.file()};
        for (const LinkedStation& station : stations)
            places.push_back(station.file());
        for (const QString& place : places) {
            RawDatabase raw(place);
            std::map<QString, qint64> known;
            for (const QString& text :
                 raw.column(u"SELECT seen FROM library_meetings WHERE seen <> '{}' ORDER BY id"_s))
                for (const auto& [library, version] : seenFromText(text)) {
                    QVERIFY2(known[library] < version, qPrintable(text));
                    known[library] = version;
                }
            QVERIFY(known.size() >= 2);
        }
    }
    void whatIsReadInPartsIsTheSame()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        std::array<LinkedStation, 2> stations;
        std::mt19937 random(3);
        const auto database = valueOf(Database::open(server.file()));
        ReadMeetings inParts;
        for (int i = 0; i < 20; ++i) {
            LinkedStation& station = stations[random() % stations.size()];
            changeSomething(*station.library, random);
            station.bringInStep(*plant);
            ReadMeetings atOnce;
            const PlantHistory whole = valueOf(knownHistory(*database, atOnce));
            const PlantHistory history = valueOf(knownHistory(*database, inParts));
            QCOMPARE(history.meetings.size(), whole.meetings.size());
            QCOMPARE(canonicalJson(plantState(history)), canonicalJson(plantState(whole)));
        }
        QVERIFY(inParts.meetings.size() > 20);
    }
    /// Beside the numbers and deliveries of millions of inspections.
    void changesAreFoundByAnIndex()
    {
        GRIPSCOPE_OF_FILES_ALONE("SQLite says how it finds them")
        const LibraryFolder folder;
        folder.open();
        RawDatabase raw(folder.file());
        const QString meetings = QString::number(ledgeredTable(u"library_meetings"_s)->code);
        for (const QString& sql :
             {u"SELECT rowid, library, version, seen FROM library_meetings WHERE seen <> '{}'"_s,
              u"SELECT other FROM library_meetings WHERE heads = '{}' ORDER BY id DESC LIMIT 1"_s,
              u"SELECT rowid, content FROM merged_rows WHERE table_code = "_s + meetings})
            for (const QString& step : raw.column(u"EXPLAIN QUERY PLAN "_s + sql))
                QVERIFY2(step.contains(u"INDEX"_s), qPrintable(sql + u": "_s + step));
    }
    void aChangeMadeWhileTheServerIsReadGoesThereFirst()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation one, other;
        const QString cola = enrol(*one.library, u"Cola"_s);
        one.bringInStep(*plant);
        other.bringInStep(*plant);
        valueOf(one.library->renameType(cola, u"Cola 330"_s, why));
        one.bringInStep(*plant);

        const auto there = valueOf(Database::open(server.file()));
        const auto here = valueOf(Database::open(other.file()));
        const qint64 delivered = valueOf(other.library->version());
        const ServerTypes read = valueOf(readServerTypes(*there, *here));
        QVERIFY(read.anyNew());
        valueOf(other.library->approveType(cola, u"Ben"_s));
        const FetchedTypes late = valueOf(takeServerTypes(read, *here, delivered));
        QVERIFY(late.isLate);
        QCOMPARE(late.rows, 0);
        other.bringInStep(*plant);
        one.bringInStep(*plant);
        QCOMPARE(inForce(*other.library), inForce(*one.library));
        QVERIFY(valueOf(one.library->findType(u"Cola 330"_s)));
    }
    void anOlderCopyOfAStationIsRefused()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation station;
        static_cast<void>(enrol(*station.library, u"Cola"_s));
        const QString copy = station.folder.filePath(u"copy.db"_s);
        station.library.reset();
        QVERIFY(QFile::copy(station.file(), copy));
        station.library = valueOf(Library::open(station.file()));
        valueOf(station.library->addInspection(anInspection()));
        station.bringInStep(*plant);
        const auto old = valueOf(Library::open(copy));
        valueOf(old->addInspection(anInspection()));
        const auto refused = old->exchangeWith(*plant, {}, linksOfStep);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::StorageOpen);
        QCOMPARE(valueOf(plant->inspectionCounts()).total, 1);
    }
    void anotherServerAndAnotherFileAreRefused()
    {
        LinkedStation first, second; // as servers
        LinkedStation one, other;
        static_cast<void>(enrol(*one.library, u"Cola"_s));
        one.bringInStep(*first.library);
        other.bringInStep(*first.library);
        const auto elsewhere = other.library->exchangeWith(*second.library, {}, linksOfStep);
        QVERIFY(!elsewhere);
        QVERIFY2(elsewhere.error().describe().contains(u"another server"), qPrintable(whyNot(elsewhere)));
        const auto merged = one.library->mergeLibrary(other.file(), why);
        QVERIFY(!merged);
        QVERIFY2(merged.error().describe().contains(u"library sync"), qPrintable(whyNot(merged)));
    }

private:
    int m_revisions = 0;
};

GRIPSCOPE_TEST(LibraryExchangeTest)
#include "library_exchange_test.moc"
