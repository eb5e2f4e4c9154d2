// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/database.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

class LibraryCorruptionTest : public QObject {
    Q_OBJECT
private slots:
    void aDamagedRecordingIsNoticed_data()
    {
        QTest::addColumn<QString>("damage");
        const QString set = u"UPDATE recordings SET "_s;
        QTest::newRow("one byte in the middle")
            << set + u"packed = CAST(SUBSTR(packed, 1, 500) || X'5A5A' || SUBSTR(packed, 503) AS BLOB)"_s;
        QTest::newRow("cut off") << set + u"packed = SUBSTR(packed, 1, LENGTH(packed) - 10)"_s;
        QTest::newRow("empty") << set + u"packed = X''"_s;
        QTest::newRow("a size of 4 GB") << set + u"packed = CAST(X'FFFFFFFF' || SUBSTR(packed, 5) AS BLOB)"_s;
        QTest::newRow("another recording's digest") << set + u"sha256 = '00'"_s;
        QTest::newRow("no zlib data")
            << set + u"packed = CAST(SUBSTR(packed, 1, 4) || ZEROBLOB(100) AS BLOB)"_s;
    }
    void aDamagedRecordingIsNoticed()
    {
        QFETCH(QString, damage);
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString typeId = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        const QString graspId = valueOf(library->addGrasp(aGrasp(typeId))).id;
        QVERIFY(library->recording(graspId));
        RawDatabase(folder.file()).run(damage);
        QCOMPARE(library->recording(graspId).error().code, ErrorCode::StorageCorrupt);
        QVERIFY(valueOf(library->grasp(graspId))->parameters); // the rest can still be read
    }
    void aRecordingLargerThanAnyIsNotUnpacked()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString typeId = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        const QString graspId = valueOf(library->addGrasp(aGrasp(typeId))).id;
        // Both sizes agree: 4 GB of zeros are 4 MB packed.
        RawDatabase(folder.file())
            .run(
                u"UPDATE recordings SET bytes = 4294967295, packed = CAST(X'FFFFFFFF' || SUBSTR(packed, 5) AS BLOB)"_s);
        const auto recording = library->recording(graspId);
        QCOMPARE(recording.error().code, ErrorCode::StorageCorrupt);
        QVERIFY(recording.error().describe().contains(u"4294967295"_s));
    }
    void whatCannotBeIsKeptOutByTheTablesThemselves_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::newRow("squeeze of no type") << u"UPDATE grasps SET type_id = 'nobody'"_s;
        QTest::newRow("estimate of no squeeze") << u"UPDATE estimates SET grasp_id = 'nobody'"_s;
        QTest::newRow("two types of one name")
            << u"INSERT INTO types SELECT 'other', station, created_utc, name FROM types"_s;
        QTest::newRow("placed in no type")
            << u"INSERT INTO placements SELECT 'p', '', '', id, 9, 'nobody', 1 FROM grasps"_s;
        QTest::newRow("unknown status")
            << u"INSERT INTO type_states SELECT 's', '', '', id, 9, 'A', 'liked', 1, '' FROM types"_s;
        QTest::newRow("two changes with one version")
            << u"INSERT INTO library_changes SELECT 'c', '', '', version, kind, '', '', 0, '', '' FROM library_changes"_s;
    }
    void whatCannotBeIsKeptOutByTheTablesThemselves()
    {
        QFETCH(QString, sql);
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString typeId = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        valueOf(library->addGrasp(aGrasp(typeId)));
        const auto database = valueOf(Database::open(folder.file()));
        QCOMPARE(database->execute(sql, u"test"_s).error().code, ErrorCode::StorageFailed);
    }
};

GRIPSCOPE_TEST(LibraryCorruptionTest)
#include "library_corruption_test.moc"
