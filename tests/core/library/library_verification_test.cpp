// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/ledger_writer.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/ledger/station_key.h"
#include "core/library/migrations/migration.h"
#include "core/library/sql/database.h"
#include "core/library/verification/library_verification.h"
#include "core/session/enroll/enrollment_storage.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/raw_database.h"
#include "tests/core/library/tampering.h"
#include "tests/core/session/session_recordings.h"
#include "tests/support/ordinary_user.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <random>

using namespace gripscope;
using namespace gripscope::test;

namespace {

LibraryVerification verified(const QString& file)
{
    return valueOf(verifyLibrary(file));
}

QString spelled(const LibraryVerification& found)
{
    QStringList lines;
    for (const LibraryDifference& difference : found.differences)
        lines += u"%1 %2: %3"_s.arg(difference.table, difference.row, difference.what);
    return lines.join(u'\n');
}

bool names(const LibraryVerification& found, const QString& table, const QString& row)
{
    return std::ranges::any_of(found.differences, [&](const LibraryDifference& difference) {
        return difference.table == table && difference.row == row;
    });
}

/// Of two contents, the first line that differs.
QString firstDifference(const QByteArray& before, const QByteArray& after)
{
    const QList<QByteArray> old = before.split('\n');
    const QList<QByteArray> now = after.split('\n');
    for (qsizetype i = 0; i < std::min(old.size(), now.size()); ++i)
        if (old[i] != now[i])
            return u"%1 became %2"_s.arg(QString::fromUtf8(old[i].left(400)),
                                         QString::fromUtf8(now[i].left(400)));
    return u"%1 lines became %2"_s.arg(old.size()).arg(now.size());
}

/// A whole library that nobody has open, and what the second place knows of it, as bytes, to be written anew
/// for each try.
struct WholeLibrary {
    LibraryFolder folder;
    QByteArray bytes, witness;
    WholeLibrary()
    {
        fillEveryTable(*folder.open());
        bytes = bytesOf(folder.file());
        witness = bytesOf(witnessFile(folder.file()));
    }
    [[nodiscard]] QString restored(const QByteArray& content) const
    {
        writeBytes(folder.file(), content);
        writeBytes(witnessFile(folder.file()), witness);
        return folder.file();
    }
    [[nodiscard]] QString edited(const QString& sql) const
    {
        RawDatabase(restored(bytes)).run(sql);
        return folder.file();
    }
};

} // namespace

/// `library verify`: what was written past the program is found and named, wherever it is.
class LibraryVerificationTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { m_sample = std::make_unique<WholeLibrary>(); }
    void init() { static_cast<void>(m_sample->restored(m_sample->bytes)); }
    void whatTheProgramWroteIsWhole()
    {
        const WholeLibrary& sample = *m_sample;
        RawDatabase raw(sample.folder.file());
        qint64 rows = 0;
        for (const LedgeredTable& table : ledgeredTables()) {
            const qint64 count = raw.count(table.name);
            QVERIFY2(count > 0, qPrintable(table.name));
            rows += count;
        }
        const LibraryVerification found = verified(sample.folder.file());
        QCOMPARE(spelled(found), u""_s);
        QVERIFY(found.whole());
        QCOMPARE(found.rows, rows);
        QVERIFY(found.witness == WitnessState::Matched);
        QCOMPARE(found.chains.size(), std::size_t(1));
        QVERIFY(found.chains[0].hasSignatures && found.chains[0].witnessed);
        QVERIFY(inWords(found).contains(QString::number(rows)));
    }

    void anEditIsNamedByTableAndRow_data()
    {
        QTest::addColumn<QString>("table");
        QTest::addColumn<QString>("edit");
        const auto edit = [](const char* name, const QString& table, const QString& set) {
            QTest::newRow(name) << table << u"UPDATE %1 SET %2 WHERE rowid = 1"_s.arg(table, set);
        };
        edit("a verdict", u"inspections"_s, u"verdict = 'type', type_name = 'B'"_s);
        edit("a mass", u"estimates"_s, u"m = m * 1.0000000000000002"_s);
        edit("a failed estimate", u"estimates"_s, u"status = 'not_converged'"_s);
        edit("a recording", u"recordings"_s, u"packed = CAST(packed || X'00' AS BLOB)"_s);
        edit("an operator", u"people"_s, u"role = 'supervisor', name = name || 'x'"_s);
        edit("a secret", u"people"_s, u"secret_hash = 'x'"_s);
        edit("a policy", u"policies"_s, u"value = 'signed_in'"_s);
        edit("a limit", u"type_versions"_s, u"max_force_n = 500"_s);
        edit("an approval", u"type_states"_s, u"status = 'retired'"_s);
        edit("a tried PIN", u"sign_in_tries"_s, u"created_utc = '2000'"_s);
        edit("a reason", u"audit_entries"_s, u"reason = 'another'"_s);
        edit("a calibration", u"calibrations"_s, u"due_date = '2099-01-01'"_s);
        edit("a lag", u"measuring_chains"_s, u"force_lag_s = 0"_s);
        edit("a document", u"documents"_s, u"document = '{}'"_s);
        edit("a tally", u"inspection_tallies"_s, u"n = n + 1"_s);
        edit("a batch", u"batches"_s, u"target = 1"_s);
        edit("what the schema is", u"schema_migrations"_s, u"program = '9.9'"_s);
    }
    void anEditIsNamedByTableAndRow()
    {
        QFETCH(QString, table);
        QFETCH(QString, edit);
        const WholeLibrary& sample = *m_sample;
        const QString key = ledgeredTable(table)->key;
        const QString row = RawDatabase(sample.folder.file())
                                .run(u"SELECT %1 FROM %2 WHERE rowid = 1"_s.arg(key, table))
                                .toString();
        const LibraryVerification found = verified(sample.edited(edit));
        QVERIFY2(names(found, table, row), qPrintable(spelled(found)));
    }
    void aTallyThatIsNotWhatCountingFindsIsNamed()
    {
        const LibraryVerification found =
            verified(m_sample->edited(u"UPDATE inspections SET verdict = 'unknown' WHERE number = 1"_s));
        QVERIFY2(names(found, u"inspection_tallies"_s, u"1"_s), qPrintable(spelled(found)));
    }
    void rowsThatCameOrWentAreNamed()
    {
        const WholeLibrary& sample = *m_sample;
        const QString id = RawDatabase(sample.folder.file())
                               .run(u"SELECT id FROM inspections WHERE number = 1"_s)
                               .toString();
        QVERIFY(names(verified(sample.edited(u"DELETE FROM inspections WHERE number = 1"_s)),
                      u"inspections"_s, id));
        const LibraryVerification more = verified(
            sample.edited(u"INSERT INTO policies VALUES ('mine', 's', '2026', 'arming', 9, 'signed_in')"_s));
        QVERIFY(names(more, u"policies"_s, u"mine"_s));
        QVERIFY(more.differences[0].what.contains(u"past this program"_s));
        // A row that takes another's place: as many as before.
        const LibraryVerification instead = verified(sample.edited(u"UPDATE policies SET id = 'mine'"_s));
        QVERIFY(names(instead, u"policies"_s, u"mine"_s));
        QCOMPARE(instead.differences.size(), std::size_t(2));
    }

    /// Seeded, so that a failure can be looked at; the thousand are for GRIPSCOPE_TAMPERINGS=1000.
    void everyRandomEditIsFoundAndNamed()
    {
        const WholeLibrary& sample = *m_sample;
        std::mt19937 random(1);
        for (int i = 0; i < tamperings(); ++i) {
            const QString file = sample.restored(sample.bytes);
            const std::optional<RandomEdit> edit = editAtRandom(file, random);
            if (!edit) { // what the tables themselves refuse, or what changes nothing
                --i;
                continue;
            }
            const auto found = verifyLibrary(file);
            if (!found) // of another version, by that edit
                QCOMPARE(edit->table, u"schema_migrations"_s);
            else
                QVERIFY2(names(*found, edit->table, edit->row),
                         qPrintable(u"%1: %2"_s.arg(edit->sql, spelled(*found))));
        }
    }
    void everyRandomBitIsFound()
    {
        const WholeLibrary& sample = *m_sample;
        const QByteArray content = contentOf(sample.folder.file());
        std::mt19937 random(2);
        for (int i = 0; i < tamperings(); ++i) {
            const auto bit = std::uniform_int_distribution<qsizetype>(0, 8 * sample.bytes.size() - 1)(random);
            QByteArray turned = sample.bytes;
            turned[bit / 8] = char(turned[bit / 8] ^ (1 << (bit % 8)));
            const QString file = sample.restored(turned);
            if (contentOf(file) == content) { // a byte that nobody reads
                --i;
                continue;
            }
            const auto found = verifyLibrary(file);
            QVERIFY2(!found || !found->whole(),
                     qPrintable(u"bit %1: %2"_s.arg(bit).arg(firstDifference(content, contentOf(file)))));
            QVERIFY(!found || !found->differences[0].what.isEmpty());
        }
    }

    void theLedgerItselfIsHeldToo_data()
    {
        QTest::addColumn<QString>("edit");
        QTest::newRow("a link less") << u"DELETE FROM ledger WHERE number = 3"_s;
        QTest::newRow("the first links less") << u"DELETE FROM ledger WHERE number < 3"_s;
        QTest::newRow("none") << u"DELETE FROM ledger"_s;
        QTest::newRow("the last less")
            << u"DELETE FROM ledger WHERE number = (SELECT MAX(number) FROM ledger)"_s;
        QTest::newRow("the kind") << u"UPDATE ledger SET kind = 'found' WHERE number = 3"_s;
        for (const char* column : {"chain", "kind", "created_utc"})
            QTest::addRow("bytes as %s", column)
                << u"UPDATE ledger SET %1 = CAST(%1 AS BLOB) WHERE number = 3"_s.arg(QLatin1String(column));
        QTest::newRow("the format") << u"UPDATE ledger SET format = 2 WHERE number = 3"_s;
        QTest::newRow("the time") << u"UPDATE ledger SET created_utc = '2000' WHERE number = 3"_s;
        QTest::newRow("the chain") << u"UPDATE ledger SET chain = 'x/' || SUBSTR(chain, -16)"_s;
        QTest::newRow("no signatures") << u"UPDATE ledger SET signer = X'', signature = X''"_s;
        QTest::newRow("one signature") << u"UPDATE ledger SET signature = X'00' WHERE number = 3"_s;
        QTest::newRow("the last signature")
            << u"UPDATE ledger SET signature = ZEROBLOB(64) WHERE number = (SELECT MAX(number) FROM ledger)"_s;
        QTest::newRow("leaves that cannot be read") << u"UPDATE ledger SET leaves = X'FF' WHERE number = 3"_s;
        QTest::newRow("leaves of another link")
            << u"UPDATE ledger SET leaves = (SELECT o.leaves FROM ledger o WHERE o.number = 4) WHERE number = 3"_s;
    }
    void theLedgerItselfIsHeldToo()
    {
        QFETCH(QString, edit);
        const WholeLibrary& sample = *m_sample;
        {
            RawDatabase raw(sample.folder.file());
            raw.run(u"PRAGMA ignore_check_constraints=ON"_s); // somebody with an editor of bytes asks nobody
            raw.run(edit);
        }
        const LibraryVerification found = verified(sample.folder.file());
        QVERIFY(!found.whole());
        QVERIFY(!found.differences[0].what.isEmpty());
    }

    void aWordThatNobodyWritesIsNoKindOfLink()
    {
        const WholeLibrary& sample = *m_sample;
        QByteArray bytes = sample.bytes;
        bytes.replace("written2", "writtan2"); // and the time behind it
        QVERIFY(bytes != sample.bytes);
        QVERIFY(!verified(sample.restored(bytes)).whole());
    }

    void anOlderCopyIsFoundWhereItIsWitnessed()
    {
        const LibraryFolder folder;
        fillEveryTable(*folder.open());
        const QByteArray older = bytesOf(folder.file());
        valueOf(folder.open()->addInspection(anInspection()));
        writeBytes(folder.file(), older);
        const LibraryVerification back = verified(folder.file());
        QVERIFY(back.witness == WitnessState::Behind);
        QCOMPARE(back.differences.size(), std::size_t(1));
        QCOMPARE(back.differences[0].table, u"ledger"_s);
        // Gone on with: the evidence stays.
        valueOf(folder.open()->addInspection(anInspection()));
        QVERIFY(!verified(folder.file()).whole());
        valueOf(folder.open()->addInspection(anInspection()));
        QVERIFY(!verified(folder.file()).whole());
        // Where nobody was witness it is said that nobody was.
        QVERIFY(QFile::remove(witnessFile(folder.file())));
        const LibraryVerification alone = verified(folder.file());
        QVERIFY2(alone.whole(), qPrintable(spelled(alone)));
        QVERIFY(alone.witness == WitnessState::Absent);
    }
    void aLedgerMadeAnewIsFoundWhereItIsWitnessed()
    {
        const WholeLibrary& sample = *m_sample;
        const QString file = sample.edited(u"UPDATE inspections SET verdict = 'unknown' WHERE number = 1"_s);
        {
            const auto database = valueOf(Database::open(file));
            valueOf(database->execute(u"DELETE FROM ledger"_s, u"test"_s));
            valueOf(enterFoundRows(*database)); // with the station's own key
        }
        const LibraryVerification found = verified(file);
        QVERIFY(!found.whole());
        const auto in = [](const QString& table) {
            return [table](const LibraryDifference& difference) { return difference.table == table; };
        };
        QVERIFY(std::ranges::any_of(found.differences, in(u"ledger"_s)));
        // The tally that was made before knows of another verdict, and nothing else differs.
        QCOMPARE(std::ranges::count_if(found.differences, in(u"ledger"_s)) +
                     std::ranges::count_if(found.differences, in(u"inspection_tallies"_s)),
                 std::ptrdiff_t(found.differences.size()));
        QVERIFY(QFile::remove(witnessFile(file)));
        QVERIFY(verified(file).witness == WitnessState::Absent); // nobody could tell: said as such
    }

    void aForeignSchemaIsNamedAndNotOpened_data()
    {
        QTest::addColumn<QString>("edit");
        QTest::addColumn<QString>("name");
        QTest::newRow("an index less")
            << u"DROP INDEX inspections_by_verdict"_s << u"inspections_by_verdict"_s;
        QTest::newRow("a table more") << u"CREATE TABLE notes (id TEXT)"_s << u"notes"_s;
        QTest::newRow("a column more") << u"ALTER TABLE types ADD COLUMN remark TEXT"_s << u"types"_s;
        QTest::newRow("a trigger")
            << u"CREATE TRIGGER sly AFTER INSERT ON inspections BEGIN DELETE FROM sign_in_tries; END"_s
            << u"sly"_s;
        QTest::newRow("a view") << u"CREATE VIEW other AS SELECT * FROM types"_s << u"other"_s;
    }
    void aForeignSchemaIsNamedAndNotOpened()
    {
        QFETCH(QString, edit);
        QFETCH(QString, name);
        const WholeLibrary& sample = *m_sample;
        const QString file = sample.edited(edit);
        const LibraryVerification found = verified(file);
        QVERIFY2(names(found, u"sqlite_master"_s, name), qPrintable(spelled(found)));
        const auto opened = Library::open(file);
        QCOMPARE(opened.error().code, ErrorCode::StorageOpen);
        QVERIFY(opened.error().describe().contains(name));
    }
    /// A byte past ASCII belongs to a name: the rule is about a column that is not there. As text it is a
    /// blank.
    void aSchemaThatOnlyLooksTheSameIsFound()
    {
        const WholeLibrary& sample = *m_sample;
        QByteArray bytes = sample.bytes;
        bytes.replace("CHECK (name <> '')", "CHECK (name\xA0<> '')");
        QVERIFY(bytes != sample.bytes);
        const QString file = sample.restored(bytes);
        QVERIFY(!verified(file).whole());
        QVERIFY(!Library::open(file));
    }
    void statisticsOfTheDatabaseAreNoForeignTable()
    {
        const WholeLibrary& sample = *m_sample;
        const QString file = sample.edited(u"ANALYZE"_s);
        QVERIFY(verified(file).whole());
        QVERIFY(Library::open(file));
    }

    void nothingIsWritten()
    {
        const WholeLibrary& sample = *m_sample;
        const QDir folder(sample.folder.folder.path());
        QVERIFY(verified(sample.folder.file()).whole());
        QCOMPARE(folder.entryList(QDir::Files), QStringList{u"library.db"_s});
        QCOMPARE(bytesOf(sample.folder.file()), sample.bytes);
    }
    void aLibraryThatMayOnlyBeReadIsVerified()
    {
        const WholeLibrary& sample = *m_sample;
        setWritable(sample.folder.file(), false);
        setWritable(sample.folder.folder.path(), false);
        {
            const OrdinaryUser user;
            QVERIFY(verified(sample.folder.file()).whole());
        }
        setWritable(sample.folder.folder.path(), true);
        setWritable(sample.folder.file(), true);
    }
    void aLibraryInUseIsReadAsItStands()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        fillEveryTable(*library);
        const LibraryVerification before = verified(folder.file());
        QVERIFY2(before.whole(), qPrintable(spelled(before)));
        valueOf(library->addInspection(anInspection()));
        const LibraryVerification after = verified(folder.file());
        QVERIFY(after.whole());
        QCOMPARE(after.rows, before.rows + 6);
        QVERIFY(after.witness == WitnessState::Matched);
    }
    void whatACrashLeftBehindIsReadFromACopy()
    {
        const LibraryFolder folder;
        const LibraryFolder other;
        qint64 rows = 0;
        {
            const auto library = folder.open();
            fillEveryTable(*library);
            rows = verified(folder.file()).rows;
            QVERIFY(QFile::copy(folder.file(), other.file()));
            QVERIFY(QFile::copy(folder.file() + u"-wal"_s, other.file() + u"-wal"_s));
        }
        const QByteArray log = bytesOf(other.file() + u"-wal"_s);
        QVERIFY(!log.isEmpty());
        const LibraryVerification found = verified(other.file());
        QVERIFY2(found.whole(), qPrintable(spelled(found)));
        QCOMPARE(found.rows, rows);
        QVERIFY(found.witness == WitnessState::Absent);
        QCOMPARE(bytesOf(other.file() + u"-wal"_s), log);
        QCOMPARE(QDir(other.folder.path()).entryList(QDir::Files),
                 (QStringList{u"library.db"_s, u"library.db-wal"_s}));
    }
    void whatFollowsFromARecordingIsWorkedOutAgain()
    {
        const LibraryFolder folder;
        {
            const auto library = folder.open();
            const Recording recording = squeezeOf(canA, 1);
            const Identification identification = identify(recording);
            NewInspection inspection = anInspection();
            inspection.grasp = makeGrasp(recording, identification, u"file.csv"_s, u"Ada"_s);
            valueOf(library->addInspection(inspection));
        }
        QCOMPARE(spelled(valueOf(verifyLibrary(folder.file(), true))), u""_s);
        // Changed together with its digest and the whole ledger, where nobody was witness.
        RawDatabase(folder.file()).run(u"UPDATE estimates SET k = 1.1 * k WHERE rank = 0"_s);
        {
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(database->execute(u"DELETE FROM ledger"_s, u"test"_s));
            valueOf(enterFoundRows(*database));
        }
        QVERIFY(QFile::remove(witnessFile(folder.file())));
        QVERIFY(verified(folder.file()).whole());
        const LibraryVerification found = valueOf(verifyLibrary(folder.file(), true));
        QCOMPARE(found.differences.size(), std::size_t(1));
        QCOMPARE(found.differences[0].table, u"estimates"_s);
    }
    void whatCannotBeReadIsAnError()
    {
        const WholeLibrary& sample = *m_sample;
        const int newest = migrations().back().version;
        QCOMPARE(verifyLibrary(u"/there/is/none"_s).error().code, ErrorCode::StorageOpen);
        QCOMPARE(verifyLibrary(sample.restored("this is no library")).error().code, ErrorCode::StorageOpen);
        QCOMPARE(
            verifyLibrary(
                sample.edited(u"UPDATE schema_migrations SET version = 99 WHERE version = %1"_s.arg(newest)))
                .error()
                .code,
            ErrorCode::StorageNewer);
        const auto older =
            verifyLibrary(sample.edited(u"DELETE FROM schema_migrations WHERE version = %1"_s.arg(newest)));
        QCOMPARE(older.error().code, ErrorCode::StorageOpen);
        QVERIFY(older.error().describe().contains(QString::number(newest - 1)));
    }

private:
    std::unique_ptr<WholeLibrary> m_sample;
};

GRIPSCOPE_TEST(LibraryVerificationTest)
#include "library_verification_test.moc"
