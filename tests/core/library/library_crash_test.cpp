// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/database.h"
#include "tests/core/library/child_process.h"
#include "tests/core/library/full_disk.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <thread>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// Nothing is half there: every squeeze has its recording, its two estimates and its document, every
/// inspection its squeeze, and SQLite finds no damage.
void verifyWhole(const QString& file, qint64 grasps)
{
    RawDatabase raw(file);
    QCOMPARE(raw.run(u"PRAGMA integrity_check"_s).toString(), u"ok"_s);
    QVERIFY(raw.run(u"PRAGMA foreign_key_check"_s).isNull());
    QCOMPARE(raw.count(u"grasps"_s), grasps);
    QCOMPARE(raw.count(u"recordings"_s), grasps);
    QCOMPARE(raw.count(u"documents"_s), grasps);
    QCOMPARE(raw.count(u"estimates"_s), 2 * grasps);
    QCOMPARE(raw.run(u"SELECT COUNT(DISTINCT grasp_id) FROM recordings"_s).toLongLong(), grasps);
}

/// A process that stores squeezes until it is killed, and writes a byte into a pipe after each.
class Writer {
public:
    Writer(const QString& file, const QString& typeId)
    {
        if (pipe(m_pipe) != 0)
            qFatal("no pipe");
        m_process = startChild([&] {
            const auto library = valueOf(Library::open(file));
            while (true) {
                valueOf(library->addGrasp(aGrasp(typeId)));
                if (write(m_pipe[1], "x", 1) != 1)
                    _exit(1);
            }
        });
        close(m_pipe[1]);
    }
    ~Writer() { close(m_pipe[0]); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Waits for a squeeze to be reported as stored.
    bool waitForOne()
    {
        char byte = 0;
        return read(m_pipe[0], &byte, 1) == 1;
    }
    /// Kills it without warning; how many more were reported.
    int kill()
    {
        ::kill(m_process, SIGKILL);
        waitpid(m_process, nullptr, 0);
        int more = 0;
        while (waitForOne())
            ++more;
        return more;
    }

private:
    int m_pipe[2] = {-1, -1};
    pid_t m_process = -1;
};

} // namespace

class LibraryCrashTest : public QObject {
    Q_OBJECT
private slots:
    void aWriterThatIsKilledLosesNothingItReported()
    {
        const LibraryFolder folder;
        const QString typeId = valueOf(folder.open()->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        qint64 stored = 0;
        for (int round = 0; round < 8; ++round) {
            Writer writer(folder.file(), typeId);
            int reported = 0;
            // Another delay each round (not a wait for anything), so that the kill falls at other points of a
            // write.
            for (; reported < 2; ++reported)
                QVERIFY(writer.waitForOne());
            QTest::qSleep(round);
            reported += writer.kill();
            const auto now = qint64(valueOf(folder.open()->grasps(typeId)).size());
            // All that was reported, and at most one that was stored just before it could be reported.
            QVERIFY(now == stored + reported || now == stored + reported + 1);
            stored = now;
            verifyWhole(folder.file(), stored);
        }
    }
    void whatWasNotCommittedIsGone()
    {
        const LibraryFolder folder;
        const QString typeId = valueOf(folder.open()->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        valueOf(folder.open()->addGrasp(aGrasp(typeId)));
        QVERIFY(endedWell(startChild([&] {
            auto database = valueOf(Database::open(folder.file()));
            // Next to no memory, so that the half transaction is in the file when the process ends.
            valueOf(database->execute(u"PRAGMA cache_size=1"_s, u"test"_s));
            const auto transaction = valueOf(Transaction::begin(*database, u"test"_s));
            for (int i = 0; i < 500; ++i)
                valueOf(database->execute(
                    u"INSERT INTO grasps (id, station, recorded_utc, type_id, operator_name, source, "
                    u"force_unit, "
                    u"position_unit, part, library_version, device_name, device_serial, firmware) "
                    u"SELECT 'half%1', station, recorded_utc, type_id, operator_name, "
                    u"source, "
                    "force_unit, position_unit, part, library_version, device_name, device_serial, firmware "
                    "FROM "
                    u"grasps WHERE id NOT LIKE 'half%'"_s.arg(i),
                    u"test"_s));
            _exit(0);
        })));
        verifyWhole(folder.file(), 1);
    }
    void anOpenTransactionOfAThreadThatEndsIsRolledBack()
    {
        const LibraryFolder folder;
        folder.open();
        std::thread([&] {
            auto database = valueOf(Database::open(folder.file()));
            const auto transaction = valueOf(Transaction::begin(*database, u"test"_s));
            valueOf(database->execute(u"INSERT INTO types VALUES ('half', '', '', 'Half')"_s, u"test"_s));
        }).join();
        QCOMPARE(RawDatabase(folder.file()).count(u"types"_s), 0);
    }
    void aFullDiskStoresNothingAndTheLibraryGoesOn()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString typeId = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        valueOf(library->addGrasp(aGrasp(typeId)));
        NewGrasp large = aGrasp(typeId);
        large.recording = awkwardRecording(20'000);
        {
            const auto room =
                rlim_t(std::max(QFile(folder.file()).size(), QFile(folder.file() + u"-wal"_s).size()));
            const FullDisk full(room + 4096);
            const auto stored = library->addGrasp(large);
            QVERIFY(!stored);
            QCOMPARE(stored.error().code, ErrorCode::StorageFailed);
            QCOMPARE(valueOf(library->grasps(typeId)).size(), std::size_t(1));
        }
        valueOf(library->addGrasp(large));
        verifyWhole(folder.file(), 2);
    }
    void aLockedLibraryIsAnErrorNotAHang()
    {
        // The library waits 10 s for a lock: the one long test here, since the time is what is promised.
        const LibraryFolder folder;
        const auto library = folder.open();
        RawDatabase raw(folder.file());
        raw.run(u"BEGIN IMMEDIATE"_s);
        QVERIFY(valueOf(library->types()).empty()); // reading goes on
        const auto added = library->addType(u"A"_s, {}, u"N"_s, u"m"_s);
        QCOMPARE(added.error().code, ErrorCode::StorageFailed);
        QVERIFY(added.error().describe().contains(u"another program"_s));
        raw.run(u"ROLLBACK"_s);
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
    }
};

GRIPSCOPE_TEST(LibraryCrashTest)
#include "library_crash_test.moc"
