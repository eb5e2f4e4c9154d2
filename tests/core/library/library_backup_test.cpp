// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/backup/library_backup.h"
#include "core/library/backup/library_restore.h"
#include "core/library/backup/library_swap.h"
#include "core/library/library_service.h"
#include "core/library/migrations/migration.h"
#include "core/people/audit_entry.h"
#include "tests/core/library/child_process.h"
#include "tests/core/library/people_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QDir>
#include <QFileInfo>
#include <QScopeGuard>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

using namespace gripscope;
using namespace gripscope::test;

namespace {

const QString restoreReason = u"the disk was exchanged"_s;

CopyProgress unwatched()
{
    return [](double) { return true; };
}

QString differencesOf(const LibraryVerification& found)
{
    QStringList lines;
    for (const LibraryDifference& difference : found.differences)
        lines += inWords(difference);
    return lines.join(u'\n');
}

/// A library with one inspection, a backup of it, and so many inspections since.
struct BackedUp {
    LibraryFolder folder;
    QString copy = folder.folder.filePath(u"copy.db"_s);
    explicit BackedUp(int since = 2)
    {
        const auto library = folder.open();
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        valueOf(library->addInspection(anInspection()));
        valueOf(backUpLibrary(folder.file(), copy, unwatched()));
        for (int i = 0; i < since; ++i)
            valueOf(library->addInspection(anInspection()));
    }
    ~BackedUp()
    {
        for (const QString& file : beside())
            QFile::remove(witnessFile(file));
    }
    [[nodiscard]] RestorePlan prepared() const
    {
        return valueOf(prepareRestore(folder.file(), copy, unwatched()));
    }
    [[nodiscard]] qint64 inspections(const QString& file) const
    {
        return valueOf(valueOf(Library::open(file))->inspectionCounts()).total;
    }
    /// All files of the folder, whole.
    [[nodiscard]] QStringList beside() const
    {
        const QDir dir(QDir(folder.folder.path()).canonicalPath());
        QStringList files;
        for (const QString& name : dir.entryList(QDir::Files))
            files += dir.filePath(name);
        return files;
    }
    /// Fills the page where a table, or an index, begins with bytes that no page has.
    void damage(const QString& what) const
    {
        qint64 page = 0, size = 0;
        {
            RawDatabase raw(folder.file());
            raw.run(u"PRAGMA journal_mode=DELETE"_s);
            page = raw.run(u"SELECT rootpage FROM sqlite_master WHERE name = '%1'"_s.arg(what)).toLongLong();
            size = raw.run(u"PRAGMA page_size"_s).toLongLong();
        }
        QByteArray bytes = bytesOf(folder.file());
        bytes.replace(int((page - 1) * size), int(size), QByteArray(int(size), char(0xee)));
        writeBytes(folder.file(), bytes);
    }
    [[nodiscard]] QStringList keptAside() const { return beside().filter(u"-before-restore-"_s); }
};

} // namespace

/// A copy of a library in use, and the way back: a rollback that is told as one.
class LibraryBackupTest : public QObject {
    Q_OBJECT
private slots:
    void aBackupIsOneStateThoughSomebodyWrites()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        for (int i = 0; i < 60; ++i)
            valueOf(library->addInspection(anInspection()));
        std::atomic<bool> over = false;
        std::atomic<int> written = 0;
        std::thread writer([&] {
            const auto other = folder.open();
            while (!over) {
                valueOf(other->addInspection(anInspection()));
                ++written;
            }
        });
        const auto stop = qScopeGuard([&] {
            over = true;
            writer.join();
        });
        for (int copy = 0; copy < 3; ++copy) {
            const QString file = folder.folder.filePath(u"copy%1.db"_s.arg(copy));
            const int before = written;
            std::vector<double> shares;
            const auto backup = backUpLibrary(folder.file(), file, [&](double share) {
                while (written == before) // at least one is stored while it is copied
                    std::this_thread::yield();
                shares.push_back(share);
                return true;
            });
            QVERIFY2(backup, qPrintable(whyNot(backup)));
            QCOMPARE(differencesOf(backup->verified), QString());
            QVERIFY(shares.front() < 1 && shares.back() == 1 && std::is_sorted(shares.begin(), shares.end()));
            QVERIFY(!QFile::exists(file + u".part"_s) && !QFile::exists(file + u"-wal"_s));
        }
        RawDatabase raw(folder.folder.filePath(u"copy2.db"_s));
        const qint64 inspections = raw.count(u"inspections"_s);
        QVERIFY(inspections > 60);
        QCOMPARE(raw.count(u"recordings"_s), inspections);
        QCOMPARE(raw.run(u"PRAGMA journal_mode"_s).toString(), u"delete"_s); // one file, whole by itself
    }
    void aProgramThatCameAndWentMeanwhileIsNoticed()
    {
        const LibraryFolder folder;
        {
            const auto library = folder.open();
            for (int i = 0; i < 60; ++i)
                valueOf(library->addInspection(anInspection()));
        } // nobody has it open
        bool came = false;
        const QString file = folder.folder.filePath(u"copy.db"_s);
        const auto backup = backUpLibrary(folder.file(), file, [&](double share) {
            if (share < 1 && !std::exchange(came, true))
                valueOf(folder.open()->addInspection(anInspection()));
            return true;
        });
        QVERIFY2(backup, qPrintable(whyNot(backup)));
        QVERIFY(came);
        QCOMPARE(differencesOf(backup->verified), QString());
        QCOMPARE(backup->contents.inspections, 61);
    }
    void lookingAtALibraryThatIsOpenTakesNoLockOffIt()
    {
        const BackedUp b;
        int there[2], back[2];
        QVERIFY(pipe(there) == 0 && pipe(back) == 0);
        char byte = 0;
        const pid_t holder = startChild([&] {
            const auto library = b.folder.open();
            valueOf(library->addInspection(anInspection()));
            valueOf(backUpLibrary(b.folder.file(), b.folder.folder.filePath(u"second.db"_s), unwatched()));
            if (write(there[1], "b", 1) != 1 || read(back[0], &byte, 1) != 1)
                _exit(1);
            valueOf(library->addInspection(anInspection()));
            if (write(there[1], "s", 1) != 1)
                _exit(1);
            pause(); // until it is killed
        });
        close(there[1]); // the end of the holder is an end for who reads
        QCOMPARE(read(there[0], &byte, 1), 1);
        valueOf(b.folder.open()->addInspection(anInspection())); // it is closed, though not by the last
        QCOMPARE(write(back[1], "g", 1), 1);
        QCOMPARE(read(there[0], &byte, 1), 1);
        ::kill(holder, SIGKILL);
        waitpid(holder, nullptr, 0);
        for (const int end : {there[0], back[0], back[1]})
            close(end);
        QCOMPARE(b.inspections(b.folder.file()), 6);
    }
    void nothingIsOverwritten()
    {
        const BackedUp b;
        const QByteArray before = bytesOf(b.copy);
        const auto again = backUpLibrary(b.folder.file(), b.copy, unwatched());
        QVERIFY(!again && again.error().code == ErrorCode::FileUnwritable);
        QCOMPARE(bytesOf(b.copy), before);
    }
    void aCancelledBackupLeavesNothing()
    {
        const BackedUp b;
        const QString file = b.folder.folder.filePath(u"second.db"_s);
        const auto backup = backUpLibrary(b.folder.file(), file, [](double) { return false; });
        QVERIFY(!backup && backup.error().code == ErrorCode::Cancelled);
        QVERIFY(b.beside().filter(u"second.db"_s).isEmpty());
    }
    void whatABackupHoldsAndWhatWouldBeLostIsKnownBefore()
    {
        const BackedUp b;
        const RestorePlan plan = b.prepared();
        QCOMPARE(plan.holds.inspections, 1);
        QVERIFY(plan.holds.newest.isValid());
        QVERIFY(plan.present);
        QCOMPARE(plan.present->inspections, 3);
        QVERIFY(plan.kinship == Kinship::Earlier);
        discard(plan);
        QVERIFY(b.beside().filter(u".restoring"_s).isEmpty());
        QCOMPARE(b.inspections(b.folder.file()), 3); // only looked at
    }
    void aRestoreIsToldAsOne()
    {
        const BackedUp b;
        const RestorePlan plan = b.prepared();
        const QString keptAs = valueOf(restoreLibrary(plan, {u"Mai"_s, {}, {}}, restoreReason));
        const LibraryVerification found = valueOf(verifyLibrary(b.folder.file()));
        QCOMPARE(differencesOf(found), QString()); // no wolf
        QVERIFY(found.witness == WitnessState::Matched);
        QCOMPARE(found.restores.size(), std::size_t(1)); // and no silence
        QCOMPARE(found.restores[0].person, u"Mai"_s);
        QCOMPARE(found.restores[0].reason, restoreReason);
        QCOMPARE(found.restores[0].backup, b.copy);
        QVERIFY2(inWords(found).contains(restoreReason) && inWords(found).contains(u"Mai"_s),
                 qPrintable(inWords(found)));
        QCOMPARE(b.inspections(b.folder.file()), 1);

        const LibraryVerification aside = valueOf(verifyLibrary(keptAs));
        QCOMPARE(differencesOf(aside), QString());
        QVERIFY(aside.witness == WitnessState::Matched); // what was known of it went along
        QCOMPARE(b.inspections(keptAs), 3);
        const auto kept = valueOf(Library::open(keptAs));
        const auto entries = valueOf(kept->auditTrail().entries({{}, {}, 1, 0}));
        QCOMPARE(entries[0].action, u"library.restore_begun"_s);
        QCOMPARE(entries[0].reason, restoreReason);
    }
    void aRestoredLibraryGoesOnAndARollbackByHandIsStillFound()
    {
        const BackedUp b;
        valueOf(restoreLibrary(b.prepared(), {u"Mai"_s, {}, {}}, restoreReason));
        {
            const auto library = b.folder.open();
            valueOf(library->addInspection(anInspection()));
            QVERIFY(valueOf(library->auditTrail().verify()).whole());
        }
        const LibraryVerification found = valueOf(verifyLibrary(b.folder.file()));
        QCOMPARE(differencesOf(found), QString());
        QVERIFY(found.witness == WitnessState::Matched);
        writeBytes(b.folder.file(), bytesOf(b.copy)); // past the program
        QVERIFY(!valueOf(verifyLibrary(b.folder.file())).whole());
    }
    void aDamagedBackupIsRefused_data()
    {
        QTest::addColumn<QString>("edit");
        QTest::newRow("a verdict") << u"UPDATE inspections SET verdict = 'unknown'"_s;
        QTest::newRow("a row less") << u"DELETE FROM estimates WHERE rank = 1"_s;
        QTest::newRow("a trigger")
            << u"CREATE TRIGGER t AFTER INSERT ON inspections BEGIN DELETE FROM people; END"_s;
        QTest::newRow("cut off") << QString();
    }
    void aDamagedBackupIsRefused()
    {
        QFETCH(QString, edit);
        const BackedUp b;
        if (edit.isEmpty())
            QVERIFY(QFile::resize(b.copy, QFile(b.copy).size() / 2));
        else
            RawDatabase(b.copy).run(edit);
        const auto plan = prepareRestore(b.folder.file(), b.copy, unwatched());
        QVERIFY(!plan);
        QVERIFY2(plan.error().describe().contains(b.copy), qPrintable(plan.error().describe()));
        QVERIFY(b.beside().filter(u".restoring"_s).isEmpty());
        QCOMPARE(b.inspections(b.folder.file()), 3);
        QCOMPARE(differencesOf(valueOf(verifyLibrary(b.folder.file()))), QString());
    }
    void whatIsNoBackupIsRefused()
    {
        const BackedUp b;
        const QString text = b.folder.folder.filePath(u"text.db"_s);
        writeBytes(text, "a letter to somebody");
        QVERIFY(!prepareRestore(b.folder.file(), text, unwatched()));
        QVERIFY(!prepareRestore(b.folder.file(), b.folder.folder.filePath(u"none.db"_s), unwatched()));
        const auto itself = prepareRestore(b.folder.file(), b.folder.file(), unwatched());
        QVERIFY(!itself && itself.error().code == ErrorCode::Usage);
        QCOMPARE(b.inspections(b.folder.file()), 3);
    }
    void aDamagedLibraryIsReplacedAndKept()
    {
        const BackedUp b;
        b.folder.open(); // what is beside it goes with its end
        const QByteArray damaged = bytesOf(b.folder.file()).left(5000);
        writeBytes(b.folder.file(), damaged);
        const RestorePlan plan = b.prepared();
        QVERIFY(!plan.present);
        const QString keptAs = valueOf(restoreLibrary(plan, {u"Mai"_s, {}, {}}, restoreReason));
        QCOMPARE(bytesOf(keptAs), damaged);
        QCOMPARE(b.inspections(b.folder.file()), 1);
        QCOMPARE(differencesOf(valueOf(verifyLibrary(b.folder.file()))), QString());
    }
    void whatLiesBesideADamagedLibraryGoesWithIt()
    {
        const BackedUp b;
        writeBytes(b.folder.file(), bytesOf(b.folder.file()).left(5000));
        writeBytes(b.folder.file() + u"-wal"_s, "a log");
        const QString keptAs = valueOf(restoreLibrary(b.prepared(), {u"Mai"_s, {}, {}}, restoreReason));
        QCOMPARE(bytesOf(keptAs + u"-wal"_s), QByteArray("a log"));
        QCOMPARE(b.inspections(b.folder.file()), 1);
    }
    void aLogWithoutItsLibraryIsNotPlayedIntoTheNext()
    {
        const BackedUp b;
        const pid_t child = startChild([&] { // killed: its log stays
            const auto library = b.folder.open();
            valueOf(library->addInspection(anInspection()));
            ::kill(getpid(), SIGKILL);
        });
        waitpid(child, nullptr, 0);
        QVERIFY(QFileInfo(b.folder.file() + u"-wal"_s).size() > 0);
        QVERIFY(QFile::remove(b.folder.file()));
        QVERIFY(QFile::copy(b.copy, nextInPlace(b.folder.file())));
        QCOMPARE(b.inspections(b.folder.file()), 1);
        QCOMPARE(b.beside().filter(u".before-wal"_s).size(), 1);
        RawDatabase raw(b.folder.file());
        QCOMPARE(raw.run(u"PRAGMA integrity_check"_s).toString(), u"ok"_s);
    }
    void whatIsDamagedFurtherInIsReplacedToo_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what :
             {"people", "policies", "audit_entries", "ledger", "sqlite_autoindex_ledger_1", "inspections"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void whatIsDamagedFurtherInIsReplacedToo()
    {
        QFETCH(QString, what);
        const BackedUp b;
        b.damage(what);
        const auto plan = prepareRestore(b.folder.file(), b.copy, unwatched());
        QVERIFY2(plan, qPrintable(whyNot(plan)));
        const auto keptAs = restoreLibrary(*plan, {u"Mai"_s, {}, {}}, restoreReason);
        QVERIFY2(keptAs, qPrintable(whyNot(keptAs)));
        QCOMPARE(b.inspections(b.folder.file()), 1);
        QCOMPARE(differencesOf(valueOf(verifyLibrary(b.folder.file()))), QString());
    }
    void aLibraryOfAnEarlierVersionIsNoDamagedOne()
    {
        const BackedUp b;
        const LibraryFolder older;
        const std::vector<Migration> steps(migrations().begin(), migrations().end() - 1);
        {
            const auto database = valueOf(Database::open(older.file()));
            valueOf(migrate(*database, steps));
        }
        const QByteArray before = bytesOf(older.file());
        const RestorePlan plan = valueOf(prepareRestore(older.file(), b.copy, unwatched()));
        QVERIFY(plan.present);
        QCOMPARE(plan.present->inspections, 0);
        QCOMPARE(bytesOf(older.file()), before); // only looked at
        const QString keptAs = valueOf(restoreLibrary(plan, {u"Mai"_s, {}, {}}, restoreReason));
        const auto kept = valueOf(Library::open(keptAs));
        QCOMPARE(valueOf(kept->auditTrail().entries({{}, {}, 1, 0}))[0].action, u"library.restore_begun"_s);
        QFile::remove(witnessFile(keptAs));
    }
    void aLibraryOfANewerProgramIsNotPutAside()
    {
        const BackedUp b;
        RawDatabase(b.folder.file())
            .run(u"INSERT INTO schema_migrations SELECT 999, name, checksum, program, station, applied_utc "
                 "FROM schema_migrations WHERE version = 1"_s);
        const auto plan = prepareRestore(b.folder.file(), b.copy, unwatched());
        QVERIFY(!plan);
        QCOMPARE(plan.error().code, ErrorCode::StorageNewer);
        QVERIFY(b.beside().filter(u".restoring"_s).isEmpty());
    }
    void itNeedsAReasonASupervisorAndTheFileAlone()
    {
        const BackedUp b;
        const auto noReason = restoreLibrary(b.prepared(), {}, u" "_s);
        QVERIFY(!noReason && noReason.error().code == ErrorCode::Usage);
        {
            const auto library = b.folder.open();
            const RestorePlan plan = b.prepared();
            QVERIFY(!restoreLibrary(plan, {}, restoreReason)); // it is open
            valueOf(library->addInspection(anInspection()));
        }
        Acting supervisor, oneOfThem;
        {
            const auto library = b.folder.open();
            const People people(*library);
            supervisor = people.supervisor(*library);
            oneOfThem = people.operatorOf(*library);
        }
        const auto refused = restoreLibrary(b.prepared(), oneOfThem, restoreReason);
        QVERIFY(!refused && refused.error().code == ErrorCode::Usage);
        QVERIFY(b.keptAside().isEmpty());
        QCOMPARE(b.inspections(b.folder.file()), 4);
        valueOf(restoreLibrary(b.prepared(), supervisor, restoreReason));
        QCOMPARE(b.inspections(b.folder.file()), 1);
        const auto library = b.folder.open();
        const auto entries = valueOf(library->auditTrail().entries({{}, {}, 1, 0}));
        QCOMPARE(entries[0].action, u"library.restored"_s);
        QCOMPARE(entries[0].person, u"Sam"_s); // though the backup knows no Sam
    }
    void killedBetweenTheTwoNamesItIsFinished()
    {
        const BackedUp b;
        valueOf(restoreLibrary(b.prepared(), {}, restoreReason));
        // As it lies in the moment between: the one before has its name, the next one not yet.
        QVERIFY(QFile::rename(b.folder.file(), nextInPlace(b.folder.file())));
        QCOMPARE(b.inspections(b.folder.file()), 1);
        QCOMPARE(differencesOf(valueOf(verifyLibrary(b.folder.file()))), QString());
    }
    void killedAtAnyMomentEitherLibraryIsThereAndWhole()
    {
        const BackedUp b;
        for (int round = 0; round < 20; ++round) {
            const pid_t child = startChild([&] {
                const auto plan = prepareRestore(b.folder.file(), b.copy, unwatched());
                if (plan)
                    static_cast<void>(restoreLibrary(*plan, {u"Mai"_s, {}, {}}, restoreReason));
            });
            // Another delay each round, so that the kill falls at other points (and after the last).
            QTest::qSleep(1 + 8 * round);
            ::kill(child, SIGKILL);
            int status = 0;
            waitpid(child, &status, 0);
            const qint64 inspections = b.inspections(b.folder.file());
            const LibraryVerification found = valueOf(verifyLibrary(b.folder.file()));
            QVERIFY2(found.whole(), qPrintable(differencesOf(found)));
            QVERIFY(inspections == 3 || inspections == 1);
            QCOMPARE(inspections == 1, !found.restores.empty());
            if (inspections == 1) { // begin anew, past the program but for the last word
                const QStringList kept = b.keptAside();
                QVERIFY(!kept.isEmpty());
                QCOMPARE(b.inspections(kept.back()), 3);
                valueOf(restoreLibrary(valueOf(prepareRestore(b.folder.file(), kept.back(), unwatched())), {},
                                       restoreReason));
                QVERIFY(!valueOf(verifyLibrary(b.folder.file())).restores.empty());
                break;
            }
        }
    }
    void theServiceGivesTheFileAwayAndOpensItAgain()
    {
        const BackedUp b;
        LibraryService service(b.folder.file());
        QCOMPARE(valueOf(service.run<InspectionCounts>([](Library& l) { return l.inspectionCounts(); }).get())
                     .total,
                 3);
        service.actAs({u"Mai"_s, {}, {}});
        const RestorePlan plan = b.prepared();
        valueOf(service
                    .runClosed<QString>(
                        [&](const Acting& acting) { return restoreLibrary(plan, acting, restoreReason); })
                    .get());
        QCOMPARE(valueOf(service.run<InspectionCounts>([](Library& l) { return l.inspectionCounts(); }).get())
                     .total,
                 1);
        QCOMPARE(valueOf(verifyLibrary(b.folder.file())).restores[0].person, u"Mai"_s);
    }
};

GRIPSCOPE_TEST(LibraryBackupTest)
#include "library_backup_test.moc"
