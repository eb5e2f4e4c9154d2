// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_record.h"
#include "core/library/audit/audit_trail.h"
#include "core/library/people/people_register.h"
#include "core/library/records/enrollment_draft.h"
#include "core/library/records/history.h"
#include "core/library/verification/library_verification.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/ordinary_user.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFileInfo>
#include <QTest>

#include <algorithm>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A library as an earlier version of the schema left it, with one type, squeeze and inspection and, from
/// version 2, one gripper's channels, from version 5 their calibration; from SQL alone, but for the ledger
/// and what came after it, which have no rows without this program.
void makeVersion(const QString& file, int version)
{
    constexpr int lastOfSql = 11;
    {
        RawDatabase raw(file);
        for (int part = 1; part <= std::min(version, lastOfSql); ++part) {
            const QString name = u"/library_version_%1.sql"_s.arg(part);
            const QString script = QString::fromUtf8(bytesOf(QStringLiteral(GRIPSCOPE_TEST_DATA) + name));
            if (script.isEmpty())
                qFatal("tests/data%s is missing", qPrintable(name));
            for (const QString& statement : statementsOf(script))
                raw.run(statement);
        }
    }
    if (version > lastOfSql)
        valueOf(migrate(*valueOf(Database::open(file)), migrationsUpTo(version)));
}

} // namespace

class LibraryOpenTest : public QObject {
    Q_OBJECT
private slots:
    void aNewFileGetsTheNewestSchema()
    {
        const LibraryFolder folder;
        QCOMPARE(folder.open()->schemaVersion(), migrations().back().version);
        RawDatabase raw(folder.file());
        QCOMPARE(raw.count(u"schema_migrations"_s), qint64(migrations().size()));
        QCOMPARE(raw.run(u"SELECT checksum FROM schema_migrations WHERE version = 1"_s).toString(),
                 migrations()[0].checksum());
        if (!onServer())
            QCOMPARE(raw.run(u"PRAGMA journal_mode"_s).toString(), u"wal"_s);
    }
    void anEmptyFileBecomesALibrary()
    {
        GRIPSCOPE_OF_FILES_ALONE("a database is there, or is not")
        const LibraryFolder folder;
        writeBytes(folder.file(), {});
        QVERIFY(Library::open(folder.file()));
    }
    void aFileOfAnEarlierVersionOpensWithAllThatIsInIt_data()
    {
        QTest::addColumn<int>("version");
        // From 12 on a file has a ledger, which SQL alone does not make: see LibraryVoidsTest.
        for (int version = 1; version < 12; ++version)
            QTest::addRow("version %d", version) << version;
    }
    void aFileOfAnEarlierVersionOpensWithAllThatIsInIt()
    {
        QFETCH(int, version);
        const LibraryFolder folder;
        makeVersion(folder.file(), version);
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        const auto type = valueOf(library->findType(u"Can"_s));
        QVERIFY(type && type->approved);
        QCOMPARE(type->squeezes, 1);
        QCOMPARE(type->recipe.peak_N, 11.0);
        const auto squeezes = valueOf(library->enrolledSqueezes());
        QCOMPARE(squeezes.size(), std::size_t(1));
        QVERIFY((squeezes[0].parameters == MassDampingStiffness{0.04, 43, 9990}));
        const auto inspections = valueOf(library->inspections({}));
        QCOMPARE(inspections.size(), std::size_t(1));
        QCOMPARE(inspections[0].reason.describe(), u"It was so."_s);
        QCOMPARE(inspections[0].batch, QString());
        QCOMPARE(type->code, QString());
        QVERIFY(type->limits.isEmpty() && !inspections[0].conformity);
        // What was not recorded then is not made up.
        const HistoryQuery inspected{.kind = SqueezeKind::Inspection};
        const HistoryEntry before =
            valueOf(library->historyEntries(valueOf(library->historyKeys(inspected)).part(0, 1))).at(0);
        QVERIFY(before.heldTo.falseReject && before.heldTo.wrongType && !before.heldTo.strangerAccept);
        QVERIFY(!before.heldTo.robust && !before.heldTo.confidence && !before.libraryVersion);
        QVERIFY(!before.forceCalibration && !before.positionCalibration && before.checksFailed.isEmpty());
        const HistoryInForce then = valueOf(library->historyInForce(inspected));
        QCOMPARE(then.withoutVersion, 1);
        QVERIFY(!then.firstVersion && then.rates.size() == 1);
        QCOMPARE(valueOf(library->addInspection(anInspection())).number, 8);
        // What was approved and dropped before versions were kept is told as versions, and can be undone.
        const auto changes = valueOf(library->changes(10));
        QCOMPARE(changes.size(), std::size_t(2));
        QCOMPARE(inWords(changes[0]), u"1 squeeze of Can was dropped."_s);
        QCOMPARE(changes[0].reason, u"slipped"_s);
        QCOMPARE(inWords(changes[1]), u"Can was approved."_s);
        QCOMPARE(changes[1].operatorName, u"Ada"_s);
        valueOf(library->restoreVersion(1, {u"Ada"_s, u"it had not slipped"_s}));
        QCOMPARE(valueOf(library->findType(u"Can"_s))->squeezes, 2);
        const auto chain = valueOf(library->measuringChain(u"0001"_s));
        QCOMPARE(chain.has_value(), version > 1);
        const MeasuringChain stored{
            2e-6, 0, 0.002, 0.001, 1e-5, 1e-6, GripperBaseline{{0.01, 2, 300}, {0.001, 0.2, 30}}, {}};
        if (chain)
            QVERIFY(chain->chain == stored);
        const auto calibrations = valueOf(library->calibrations(u"0001"_s, 10));
        QCOMPARE(calibrations.size(), std::size_t(version > 4 ? 1 : 0));
        QVERIFY(calibrations.empty() || calibrations[0].points.size() == 3);
        const auto drafts = valueOf(library->drafts());
        QCOMPARE(drafts.size(), std::size_t(version > 5 ? 1 : 0));
        QVERIFY(drafts.empty() || drafts[0].name == u"Jar"_s);
        QCOMPARE(valueOf(library->calibrationsInForce(u"0001"_s)).reference.has_value(), version > 6);
        const auto checks = valueOf(library->referenceChecks(u"0001"_s, 10));
        QCOMPARE(checks.size(), std::size_t(version > 6 ? 1 : 0));
        // Nobody has to sign in, and the trail begins with what is done from now on.
        QVERIFY(!valueOf(library->people().inForce()));
        const auto trail = valueOf(library->auditTrail().verify());
        QVERIFY(trail.whole());
        QCOMPARE(trail.head.entries, 1);
        QCOMPARE(valueOf(library->auditTrail().entries({})).front().reason, u"it had not slipped"_s);
        // What was there entered the ledger as it was found, and the ledger goes on from there.
        const LibraryVerification verified = valueOf(verifyLibrary(folder.file()));
        QVERIFY(verified.whole());
        QVERIFY(verified.foundRows > version && verified.rows > verified.foundRows);
    }
    void whatWasRecognisedBeforeApprovalDecidedStaysInForce()
    {
        const LibraryFolder folder;
        makeVersion(folder.file(), 12);
        {
            RawDatabase raw(folder.file());
            // Three that were never approved: one in use, one whose enrolment goes on, one without a squeeze.
            for (const QString& name : {u"Old"_s, u"Begun"_s, u"Empty"_s}) {
                raw.run(u"INSERT INTO types (id, station, created_utc, name) SELECT '%1', station, "
                        u"created_utc, '%1' FROM types LIMIT 1"_s.arg(name));
                raw.run(
                    u"INSERT INTO type_versions (id, station, created_utc, type_id, version, recipe_name, "
                    u"peak_n, bias_n, bit_s, seconds, max_force_n, max_travel_m, force_unit, "
                    u"position_unit) SELECT 'v%1', station, created_utc, '%1', 1, recipe_name, peak_n, "
                    u"bias_n, bit_s, seconds, max_force_n, max_travel_m, force_unit, position_unit FROM "
                    u"type_versions LIMIT 1"_s.arg(name));
                raw.run(u"INSERT INTO type_states (id, station, created_utc, type_id, version, name, status, "
                        u"recipe_version) VALUES ('s%1', '', '', '%1', 2, '%1', 'enrolled', 1)"_s.arg(name));
            }
            for (const QString& name : {u"Old"_s, u"Begun"_s}) {
                raw.run(u"INSERT INTO grasps (id, station, recorded_utc, type_id, operator_name, source, "
                        u"force_unit, position_unit) SELECT 'g%1', station, recorded_utc, '%1', '', '', 'N', "
                        u"'m' FROM grasps LIMIT 1"_s.arg(name));
                raw.run(
                    u"INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, "
                    u"message, program, m, b, k, iterations) SELECT 'e%1', station, created_utc, 'g%1', 0, "
                    u"estimator, status, '', program, 0.04, 43, 9990, 1 FROM estimates LIMIT 1"_s.arg(name));
            }
            raw.run(u"INSERT INTO enrollment_drafts (id, station, created_utc, type_name, state, step, "
                    u"recipe_name, peak_n, bias_n, bit_s, seconds, max_force_n, max_travel_m, part, remark, "
                    u"operator_name, serial) VALUES ('d', '', '', 'Begun', 'open', 'squeeze', 'x', 10, 20, "
                    u"0.005, 1, 40, 0.02, '', '', '', 9)"_s);
        }
        const auto library = folder.open();
        QVERIFY(valueOf(library->findType(u"Old"_s))->approved);
        QVERIFY(!valueOf(library->findType(u"Begun"_s))->approved);
        QVERIFY(!valueOf(library->findType(u"Empty"_s))->approved);
        const LibraryChange change = valueOf(library->changes(1)).at(0);
        QCOMPARE(inWords(change), u"Old was approved."_s);
        QVERIFY(change.reason.startsWith(u"as found"_s));
        QCOMPARE(change.version, valueOf(library->version()));
        QCOMPARE(valueOf(library->approvedSqueezes()).size(), std::size_t(2));
        // It is done once: what is enrolled from now on waits.
        const QString id = valueOf(library->addType(u"New"_s, {}, u"N"_s, u"m"_s)).id;
        valueOf(library->addGrasp(aGrasp(id)));
        QVERIFY(!valueOf(valueOf(Library::open(folder.file()))->findType(u"New"_s))->approved);
    }
    void migrationsAreNeverEdited()
    {
        // What was released is in users' files: a change needs a further step, not another text.
        QCOMPARE(migrations()[0].checksum(),
                 u"3fe0d89f2b05a7707d258048112e93e811eaeedda21d2fd53aa4554bb97e77c9"_s);
        QCOMPARE(migrations()[1].checksum(),
                 u"9372b5894d92b40436f836603ca4079adff5daaa3771bb30cafc6a3b373a5afe"_s);
        QCOMPARE(migrations()[2].checksum(),
                 u"d9dce13d44c1015bbeb24bd09c2ec4b7f0c9c6c9b0f49fdecc871916c1716a84"_s);
        QCOMPARE(migrations()[3].checksum(),
                 u"df417d941c7bf59bbcd7a281f62730f4f446b821cadc67fe975cad7793ee6ad9"_s);
        QCOMPARE(migrations()[4].checksum(),
                 u"ec80b874498ca7ec92bac62d324aa44dbb2303a2826586f7085a908edb3d760b"_s);
        QCOMPARE(migrations()[5].checksum(),
                 u"f07cec2ca6f45dcb71f40d83f40432f15a1dbcc3245a9f1ce7e62eed29a6aa13"_s);
        QCOMPARE(migrations()[6].checksum(),
                 u"f7842ddc6ff44aaf6c12793077c3dd46143fa76204f9f993dba6a89c7f6c566c"_s);
        QCOMPARE(migrations()[7].checksum(),
                 u"517bb996476637705568edfda69712aa9be39162f767cf970caa259e29f09eac"_s);
        QCOMPARE(migrations()[8].checksum(),
                 u"3f2565d5ab259e5129148646da42fe3cc2fa526dba3245630a347515c0c0ead7"_s);
        QCOMPARE(migrations()[9].checksum(),
                 u"f7301b5a84b65eae0bdcbc682b302de2919f6f30d755ae64ae7d072027c0c453"_s);
    }
    void furtherStepsAreAppliedInOrderAndOnce()
    {
        const LibraryFolder folder;
        std::vector<Migration> steps = {{1, u"one"_s, {u"CREATE TABLE a (x {blob})"_s}}};
        {
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, steps));
        }
        steps.push_back(
            {2, u"two"_s, {u"ALTER TABLE a ADD COLUMN y TEXT"_s, u"INSERT INTO a (y) VALUES ('kept')"_s}});
        for (int i = 0; i < 2; ++i) {
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, steps));
            QCOMPARE(valueOf(schemaVersion(*database)), 2);
        }
        QCOMPARE(RawDatabase(folder.file()).count(u"a"_s), 1);
    }
    void aStepThatFailsLeavesTheVersionBefore()
    {
        const LibraryFolder folder;
        const std::vector<Migration> steps = {{1, u"one"_s, {u"CREATE TABLE a (x TEXT)"_s}},
                                              {2, u"two"_s, {u"CREATE TABLE b (x TEXT)"_s, u"no SQL"_s}}};
        const auto database = valueOf(Database::open(folder.file()));
        QCOMPARE(migrate(*database, steps).error().code, ErrorCode::StorageFailed);
        QCOMPARE(valueOf(schemaVersion(*database)), 1);
        QVERIFY(!valueOf(database->tables()).contains(u"b"_s));
    }
    void aStepAppliedWithAnotherTextIsNoticed()
    {
        const LibraryFolder folder;
        folder.open();
        RawDatabase(folder.file()).run(u"UPDATE schema_migrations SET checksum = 'another'"_s);
        QCOMPARE(Library::open(folder.file()).error().code, ErrorCode::StorageOpen);
    }
    void aNewerFileIsLeftUntouched()
    {
        const LibraryFolder folder;
        folder.open();
        RawDatabase(folder.file())
            .run(u"INSERT INTO schema_migrations VALUES (99, 'later', '', '', '', '')"_s);
        const QByteArray before = bytesOf(folder.file());
        const auto library = Library::open(folder.file());
        QCOMPARE(library.error().code, ErrorCode::StorageNewer);
        QCOMPARE(described(library.error().arguments),
                 QStringList({folder.file(), u"99"_s, QString::number(migrations().back().version)}));
        QVERIFY(bytesOf(folder.file()) == before);
        if (!onServer())
            QCOMPARE(QDir(folder.folder.path()).entryList(QDir::Files), QStringList({u"library.db"_s}));
    }
    void aNewerFileOfAnotherJournalIsLeftUntouched()
    {
        GRIPSCOPE_OF_FILES_ALONE("a file has a journal")
        const LibraryFolder folder;
        {
            RawDatabase raw(folder.file());
            raw.run(u"CREATE TABLE schema_migrations (version INTEGER)"_s);
            raw.run(u"INSERT INTO schema_migrations VALUES (99)"_s);
        }
        const QByteArray before = bytesOf(folder.file());
        QCOMPARE(Library::open(folder.file()).error().code, ErrorCode::StorageNewer);
        QVERIFY(bytesOf(folder.file()) == before);
    }
    void filesThatAreNoLibraryAreRefusedUntouched_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("text") << QByteArray("time_s,force,position\n0,1,2\n");
        QTest::newRow("short") << QByteArray("SQL");
        QTest::newRow("binary") << QByteArray(5000, '\xa5');
    }
    void filesThatAreNoLibraryAreRefusedUntouched()
    {
        GRIPSCOPE_OF_FILES_ALONE("other bytes")
        QFETCH(QByteArray, bytes);
        const LibraryFolder folder;
        writeBytes(folder.file(), bytes);
        const auto library = Library::open(folder.file());
        QCOMPARE(library.error().code, ErrorCode::StorageOpen);
        QVERIFY(library.error().describe().contains(u"another kind"_s));
        QVERIFY(bytesOf(folder.file()) == bytes);
    }
    void anotherProgramsDatabaseIsRefusedUntouched()
    {
        const LibraryFolder folder;
        RawDatabase(folder.file()).run(u"CREATE TABLE recipes (soup TEXT)"_s);
        const QByteArray before = bytesOf(folder.file());
        const auto library = Library::open(folder.file());
        QCOMPARE(library.error().code, ErrorCode::StorageOpen);
        QVERIFY(library.error().describe().contains(u"another program"_s));
        QVERIFY(bytesOf(folder.file()) == before);
    }
    void aLibraryThatRunsProgramsOfItsOwnIsRefused_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::newRow("trigger")
            << u"CREATE TRIGGER turn AFTER INSERT ON inspections BEGIN UPDATE inspections "
               "SET verdict = 'type'; END"_s;
        QTest::newRow("view") << u"CREATE VIEW all_types AS SELECT * FROM types"_s;
        QTest::newRow("computed column") << u"CREATE TABLE big (x TEXT, y BLOB AS (zeroblob(1000000000)))"_s;
        QTest::newRow("virtual table") << u"CREATE VIRTUAL TABLE words USING fts5(text)"_s;
    }
    void aLibraryThatRunsProgramsOfItsOwnIsRefused()
    {
        GRIPSCOPE_OF_FILES_ALONE("LibraryServerTest has its triggers")
        QFETCH(QString, sql);
        const LibraryFolder folder;
        QVERIFY(folder.open());
        RawDatabase(folder.file()).run(sql);
        const auto library = Library::open(folder.file());
        QVERIFY(!library);
        QCOMPARE(library.error().code, ErrorCode::StorageOpen);
        QVERIFY(library.error().describe().contains(u"a program of its own"_s));
    }
    void aDamagedDatabaseIsCorrupt()
    {
        GRIPSCOPE_OF_FILES_ALONE("other bytes")
        const LibraryFolder folder;
        valueOf(folder.open()->loadExampleTypes());
        QByteArray bytes = bytesOf(folder.file());
        bytes.replace(100, 3000, QByteArray(3000, '\x5a')); // the root of the schema, behind the header
        writeBytes(folder.file(), bytes);
        QCOMPARE(Library::open(folder.file()).error().code, ErrorCode::StorageCorrupt);
    }
    void placesThatCannotHoldAFileAreErrors_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("no name") << u""_s;
        QTest::newRow("no such folder") << u"/nowhere/at/all/library.db"_s;
        QTest::newRow("a folder") << QDir::tempPath();
        QTest::newRow("not a real disk") << u"/proc/library.db"_s;
    }
    void placesThatCannotHoldAFileAreErrors()
    {
        GRIPSCOPE_OF_FILES_ALONE("LibraryServerTest has its addresses")
        QFETCH(QString, file);
        const auto library = Library::open(file);
        QCOMPARE(library.error().code, ErrorCode::StorageOpen);
        QCOMPARE(library.error().argument(0), file);
        QVERIFY(!library.error().argument(1).isEmpty());
        QVERIFY(!QFileInfo::exists(u"/nowhere"_s));
    }
    void aFolderWithoutWritePermissionIsAnError()
    {
        GRIPSCOPE_OF_FILES_ALONE("folders")
        const LibraryFolder folder;
        setWritable(folder.folder.path(), false);
        {
            const OrdinaryUser user;
            QCOMPARE(Library::open(folder.file()).error().code, ErrorCode::StorageOpen);
        }
        setWritable(folder.folder.path(), true);
        folder.open();
        setWritable(folder.folder.path(), false);
        setWritable(folder.file(), false);
        {
            const OrdinaryUser user;
            const auto library = Library::open(folder.file()); // there, but nothing can be written beside it
            QVERIFY(!library);
            QVERIFY2(library.error().code == ErrorCode::StorageOpen ||
                         library.error().describe().contains(u"write-protected"_s),
                     qPrintable(library.error().describe()));
        }
        setWritable(folder.folder.path(), true);
    }
    void theUsersOwnLibraryGetsItsFolder()
    {
        GRIPSCOPE_OF_FILES_ALONE("folders")
        QDir(QFileInfo(Library::defaultFile()).path()).removeRecursively(); // this test's own, see OwnHome
        QVERIFY(Library::open(Library::defaultFile()));
        QVERIFY(QFileInfo::exists(Library::defaultFile()));
    }
    void aFileThatWasTakenAwayStoresNothingUnseen()
    {
        GRIPSCOPE_OF_FILES_ALONE("a file that is moved")
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(anInspection()));
        const QString away = folder.folder.filePath(u"away.db"_s);
        QVERIFY(QFile::rename(folder.file(), away));
        const auto gone = library->addInspection(anInspection());
        QCOMPARE(gone.error().code, ErrorCode::StorageFailed);
        QVERIFY2(gone.error().describe().contains(u"removed or replaced"_s),
                 qPrintable(gone.error().describe()));
        writeBytes(folder.file(), bytesOf(away)); // a copy is another file
        QCOMPARE(library->addInspection(anInspection()).error().code, ErrorCode::StorageFailed);
        QVERIFY(QFile::remove(folder.file()) && QFile::rename(away, folder.file()));
        QCOMPARE(valueOf(library->addInspection(anInspection())).number, 2);
    }
};

GRIPSCOPE_TEST(LibraryOpenTest)
#include "library_open_test.moc"
