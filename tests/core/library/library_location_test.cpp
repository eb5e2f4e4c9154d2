// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/library_location.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;

class LibraryLocationTest : public QObject {
    Q_OBJECT
private slots:
    void anyOtherTextIsAFile()
    {
        for (const QString& text : {u""_s, u"library.db"_s, u"/a b/c?d#e@f:g.db"_s, u"postgresql.db"_s}) {
            const LibraryLocation location = valueOf(LibraryLocation::parse(text));
            QVERIFY(!location.server());
            QCOMPARE(location.file(), text);
            QCOMPARE(location.text(), text);
        }
    }

    void anAddressIsTakenApartAndPutTogether_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("host");
        QTest::addColumn<int>("port");
        QTest::addColumn<QString>("database");
        QTest::addColumn<QString>("user");
        QTest::newRow("all") << u"postgresql://ada@db.example:6543/plant?sslmode=verify-full"_s
                             << u"db.example"_s << 6543 << u"plant"_s << u"ada"_s;
        QTest::newRow("least") << u"postgres://db/plant"_s << u"db"_s << 5432 << u"plant"_s << QString();
        QTest::newRow("six") << u"postgresql://ada@[::1]:5433/plant"_s << u"::1"_s << 5433 << u"plant"_s
                             << u"ada"_s;
        QTest::newRow("socket") << u"postgresql://ada@/plant?host=/run/postgresql&port=5440"_s
                                << u"/run/postgresql"_s << 5440 << u"plant"_s << u"ada"_s;
        QTest::newRow("own") << u"postgresql:///plant"_s << QString() << 5432 << u"plant"_s << QString();
        QTest::newRow("signs") << u"postgresql://a%40b@db/W%C3%BCrfel%20%26%3F"_s << u"db"_s << 5432
                               << u"Würfel &?"_s << u"a@b"_s;
    }
    void anAddressIsTakenApartAndPutTogether()
    {
        QFETCH(QString, text);
        const LibraryLocation location = valueOf(LibraryLocation::parse(text));
        QVERIFY(location.server());
        QTEST(location.server()->host, "host");
        QTEST(location.server()->port, "port");
        QTEST(location.server()->database, "database");
        QTEST(location.server()->user, "user");
        const LibraryLocation again = valueOf(LibraryLocation::parse(location.text()));
        QVERIFY2(again.server() == location.server(), qPrintable(location.text()));
        QCOMPARE(again.text(), location.text());
    }

    void whoConnectsAndHowIsNotPartOfTheKey()
    {
        const auto keyOf = [](const QString& text) { return valueOf(LibraryLocation::parse(text)).key(); };
        const QString key = keyOf(u"postgresql://ada@db.example/plant?sslmode=require"_s);
        QCOMPARE(keyOf(u"postgres://DB.example:5432/plant"_s), key);
        QVERIFY(keyOf(u"postgresql://db.example:5433/plant"_s) != key);
        QVERIFY(keyOf(u"postgresql://db.example/Plant"_s) != key);
        QCOMPARE(witnessFile(u"postgresql://ada@db.example/plant"_s),
                 witnessFile(u"postgres://db.example/plant"_s));
    }

    void aPasswordIsRefusedAndShownNowhere_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("with the user") << u"postgresql://ada:Geheim1@db/plant"_s;
        QTest::newRow("as an option") << u"postgresql://ada@db/plant?password=Geheim1"_s;
        QTest::newRow("of the key") << u"postgresql://ada@db/plant?sslpassword=Geheim1"_s;
        QTest::newRow("unreadable") << u"postgresql://ada:Geheim1@db:x/plant"_s;
        QTest::newRow("with its own signs") << u"postgresql://ada:Geheim1@Geheim1@db/plant"_s;
    }
    void aPasswordIsRefusedAndShownNowhere()
    {
        QFETCH(QString, text);
        const auto location = LibraryLocation::parse(text);
        QVERIFY(!location);
        QVERIFY2(!location.error().describe().contains(u"Geheim1"_s),
                 qPrintable(location.error().describe()));
        QVERIFY(!shortLibraryName(text).contains(u"Geheim1"_s));
        QVERIFY(!fileWithLibrary(text, u".x"_s).contains(u"Geheim1"_s));
        QVERIFY2(location.error().describe().contains(u".pgpass"_s), qPrintable(location.error().describe()));
    }

    void whatLeadsNowhereIsRefused_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"postgresql://", "postgresql://db", "postgresql://db/", "postgresql://db:99999/plant",
              "postgresql://db:0/plant", "postgresql://db/plant/more", "postgresql://a b/plant",
              "postgresql://db/plant?sslmod=x", "postgresql://db/plant?sslmode=a;host=b",
              "postgresql://one,two/plant", "postgresql://db/plant#x"})
            QTest::newRow(text) << QString::fromUtf8(text);
    }
    void whatLeadsNowhereIsRefused()
    {
        QFETCH(QString, text);
        const auto location = LibraryLocation::parse(text);
        QVERIFY(!location);
        QCOMPARE(location.error().code, ErrorCode::StorageOpen);
    }

    void whatGoesWithALibraryIsBesideItsFileOrInTheUsersFolder()
    {
        QCOMPARE(fileWithLibrary(u"/a/b.db"_s, u".mqtt"_s), u"/a/b.db.mqtt"_s);
        const QString file = fileWithLibrary(u"postgresql://ada@db/plant"_s, u".mqtt"_s);
        QVERIFY(QFileInfo(file).isAbsolute() && file.endsWith(u".mqtt"_s));
        QVERIFY(QFileInfo(QFileInfo(file).path()).isWritable());
    }
};

GRIPSCOPE_TEST(LibraryLocationTest)
#include "library_location_test.moc"
