// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/backup/library_backup.h"
#include "core/library/backup/library_restore.h"
#include "core/library/library_service.h"
#include "core/library/records/history.h"
#include "core/library/records/history_list.h"
#include "core/library/sql/statement.h"
#include "tests/core/library/cutting_proxy.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// The address with another host (the folder of a socket), user or database.
QString elsewhere(const QString& place, const QString& what, const QString& value)
{
    const auto location = valueOf(LibraryLocation::parse(place));
    const ServerAddress& server = *location.server();
    return u"postgresql://%1@/%2?host=%3&port=5432"_s.arg(what == "user"_L1 ? value : server.user,
                                                          what == "database"_L1 ? value : server.database,
                                                          what == "host"_L1 ? value : server.host);
}

QString databaseOf(const QString& place)
{
    return valueOf(LibraryLocation::parse(place)).server()->database;
}

} // namespace

/// What a library has to stand on a server, and a file has not.
class LibraryServerTest : public QObject {
    Q_OBJECT

    static void refuses(const QString& place, const QString& words)
    {
        const auto opened = Library::open(place);
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, ErrorCode::StorageOpen);
        QVERIFY2(opened.error().describe().contains(words), qPrintable(opened.error().describe()));
    }

private slots:
    void whatKeepsItFromOpeningIsSaidWithWhatToDo()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        const QString place = folder.file();
        refuses(elsewhere(place, u"database"_s, u"nowhere"_s), u"there is no database nowhere on "_s);
        refuses(elsewhere(place, u"user"_s, u"nobody"_s), u"knows no user nobody"_s);
        refuses(elsewhere(place, u"host"_s, u"/nowhere"_s), u"no server answers at /nowhere"_s);
        refuses(u"postgresql://ada@127.0.0.1:1/plant"_s, u"no server answers at 127.0.0.1:1"_s);
    }

    void aPasswordIsFoundByTheWaysOfLibpqAlone()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        if (tellTestServer(u"SELECT 1 FROM pg_roles WHERE rolname = 'asked_for_a_password'"_s).isEmpty())
            tellTestServer(u"CREATE ROLE asked_for_a_password SUPERUSER LOGIN PASSWORD 'Geheim1'"_s);
        const QString place = elsewhere(folder.file(), u"user"_s, u"asked_for_a_password"_s);
        refuses(place, u".pgpass"_s);
        qputenv("PGPASSWORD", "Falsch1");
        refuses(place, u"refuses the password of user asked_for_a_password"_s);
        qputenv("PGPASSWORD", "Geheim1");
        QVERIFY(Library::open(place));
        qunsetenv("PGPASSWORD");
        QTemporaryDir home;
        const QString file = home.filePath(u"pgpass"_s);
        writeBytes(file, "*:*:*:asked_for_a_password:Geheim1\n");
        QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner);
        qputenv("PGPASSFILE", file.toLocal8Bit());
        QVERIFY(Library::open(place));
        qunsetenv("PGPASSFILE");
    }

    void aDatabaseThatCannotHoldEverySignIsRefused()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        tellTestServer(u"CREATE DATABASE latin1 TEMPLATE template0 ENCODING LATIN1 LOCALE_PROVIDER libc "
                       "LOCALE 'C'"_s);
        refuses(onTestServer(u"latin1"_s), u"createdb --encoding=UTF8"_s);
        dropTestDatabase(u"latin1"_s);
    }

    void whatActsByItselfIsRefused()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        folder.open();
        RawDatabase raw(folder.file());
        raw.run(
            u"CREATE FUNCTION lie() RETURNS trigger LANGUAGE plpgsql AS $$BEGIN NEW.verdict = 'type'; RETURN "
            "NEW; END$$"_s);
        raw.run(u"CREATE TRIGGER lies BEFORE INSERT ON inspections FOR EACH ROW EXECUTE FUNCTION lie()"_s);
        refuses(folder.file(), u"the trigger lies"_s);
        raw.run(u"DROP TRIGGER lies ON inspections"_s);
        QVERIFY(Library::open(folder.file()));
        raw.run(u"ALTER TABLE inspections DROP CONSTRAINT inspections_number_check"_s);
        refuses(folder.file(), u"inspections_number_check is missing"_s);
    }

    void aTextWithTheSignNulIsRefusedAndNothingIsStored()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto added = library->addType(u"A"_s + QChar(QChar::Null) + u"B"_s, {}, u"N"_s, u"m"_s);
        QVERIFY(!added);
        QVERIFY(valueOf(library->types()).empty());
        valueOf(library->addType(u"AB"_s, {}, u"N"_s, u"m"_s));
    }

    void anIdleConnectionThatWasEndedIsMadeAnew()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString database = databaseOf(folder.file());
        endConnectionsTo(database);
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)); // writes
        endConnectionsTo(database);
        QCOMPARE(valueOf(library->types()).size(), 1); // reads
        endConnectionsTo(database);
        QCOMPARE(valueOf(library->historyList({})).rows, 0); // reads one state
    }

    void aTransactionWhoseConnectionWasEndedStoresNothingAndTheNextOneDoes()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto done = library->atOnce([&]() -> Expected<void> {
            RETURN_IF_ERROR(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
            endConnectionsTo(databaseOf(folder.file()));
            return library->addType(u"B"_s, {}, u"N"_s, u"m"_s).map([](const TypeRecord&) {});
        });
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::StorageFailed);
        QVERIFY2(done.error().describe().contains(u"the server ended the connection"_s),
                 qPrintable(done.error().describe()));
        QVERIFY(valueOf(library->types()).empty());
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
    }

    void aStepThatFailedIsNotTakenForStored()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        const auto database = valueOf(Database::open(folder.file()));
        const auto transaction = valueOf(Transaction::begin(*database, u"test"_s));
        QVERIFY(!database->execute(u"SELECT 1 / 0"_s, u"test"_s));
        QVERIFY(!transaction->commit()); // the server would say that all is well
    }

    void aCommitWhoseAnswerWasLostIsAskedFor_data()
    {
        QTest::addColumn<int>("cut");
        QTest::addColumn<bool>("isBack");
        QTest::newRow("it was stored") << int(CuttingProxy::Cut::Answer) << true;
        QTest::newRow("it was not") << int(CuttingProxy::Cut::Question) << true;
        QTest::newRow("nobody knows") << int(CuttingProxy::Cut::Answer) << false;
    }
    void aCommitWhoseAnswerWasLostIsAskedFor()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        QFETCH(int, cut);
        QFETCH(bool, isBack);
        const LibraryFolder folder;
        folder.open();
        CuttingProxy proxy(valueOf(LibraryLocation::parse(folder.file())).server()->host);
        const auto library = valueOf(Library::open(elsewhere(folder.file(), u"host"_s, proxy.folder())));
        proxy.letNobodyIn(!isBack);
        proxy.cutNext(CuttingProxy::Cut(cut));
        const auto added = library->addType(u"A"_s, {}, u"N"_s, u"m"_s);
        const bool stored = cut == int(CuttingProxy::Cut::Answer);
        QCOMPARE(added.has_value(), stored && isBack);
        if (!added) {
            QCOMPARE(added.error().code, isBack ? ErrorCode::StorageFailed : ErrorCode::StorageUnknown);
        }
        proxy.letNobodyIn(false);
        QCOMPARE(valueOf(library->types()).size(), stored ? 1 : 0);
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }

    void aServerThatIsGoneIsSaidToAllWhoAskedMeanwhile()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        LibraryService service(elsewhere(folder.file(), u"host"_s, u"/nowhere"_s));
        std::vector<Pending<Expected<int>>> answers;
        for (int i = 0; i < 20; ++i)
            answers.push_back(service.run<int>([](Library&) -> Expected<int> { return 1; }));
        for (auto& answer : answers) {
            QTRY_VERIFY(answer.ready());
            QCOMPARE(answer.take()->error().code, ErrorCode::StorageOpen);
        }
    }

    void whatIsChangedPastTheProgramIsFoundByVerifying_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("table");
        QTest::newRow("a number") << u"UPDATE estimates SET k = k + 1e-9 WHERE rank = 0"_s << u"estimates"_s;
        QTest::newRow("a text") << u"UPDATE library_changes SET operator_name = 'Bob'"_s
                                << u"library_changes"_s;
        QTest::newRow("bytes") << u"UPDATE recordings SET packed = packed || X'00'"_s << u"recordings"_s;
        QTest::newRow("a row more")
            << u"INSERT INTO types (id, station, created_utc, name) VALUES ('x', '', '', "
               "'B')"_s
            << u"types"_s;
        QTest::newRow("a row less") << u"DELETE FROM documents"_s << u"documents"_s;
        QTest::newRow("the end of the ledger")
            << u"DELETE FROM ledger WHERE number = (SELECT MAX(number) FROM ledger)"_s << u"ledger"_s;
    }
    void whatIsChangedPastTheProgramIsFoundByVerifying()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        QFETCH(QString, sql);
        QFETCH(QString, table);
        const LibraryFolder folder;
        {
            const auto library = folder.open();
            const QString id = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s, u"Ada"_s)).id;
            valueOf(library->addGrasp(aGrasp(id)));
        }
        const LibraryVerification whole = valueOf(verifyLibrary(folder.file()));
        QVERIFY2(whole.whole(), qPrintable(inWords(whole)));
        RawDatabase(folder.file()).run(sql);
        const LibraryVerification found = valueOf(verifyLibrary(folder.file()));
        QVERIFY(!found.whole());
        const auto names = [&](const auto& difference) { return difference.table == table; };
        QVERIFY2(std::any_of(found.differences.begin(), found.differences.end(), names),
                 qPrintable(inWords(found)));
    }

    void itsOwnProgramsCopyItAndPutItBack()
    {
        GRIPSCOPE_OF_SERVERS_ALONE()
        const LibraryFolder folder;
        folder.open();
        const QString copy = folder.folder.filePath(u"copy"_s);
        const auto backup = backUpLibrary(folder.file(), copy, [](double) { return true; });
        QVERIFY(!backup && backup.error().describe().contains(u"pg_dump"_s));
        const auto plan = prepareRestore(folder.file(), copy, [](double) { return true; });
        QVERIFY(!plan && plan.error().describe().contains(u"pg_restore"_s));
        QVERIFY(!QFile::exists(copy));
    }
};

GRIPSCOPE_TEST(LibraryServerTest)
#include "library_server_test.moc"
