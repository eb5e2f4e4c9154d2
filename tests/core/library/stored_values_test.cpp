// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/rows.h"
#include "core/library/sql/statement.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <bit>
#include <limits>

using namespace gripscope;
using namespace gripscope::test;

/// What a statement puts in comes back the same, by whatever database.
class StoredValuesTest : public QObject {
    Q_OBJECT

    static std::unique_ptr<Database> withTable(const LibraryFolder& folder)
    {
        auto database = valueOf(Database::open(folder.file()));
        const QString table =
            u"CREATE TABLE kept (id TEXT PRIMARY KEY, n BIGINT, d DOUBLE PRECISION, t TEXT, b {blob})"_s;
        valueOf(database->execute(database->dialect().ofMigration(table), u"test"_s));
        return database;
    }

private slots:
    void numbersComeBackToTheLastBit()
    {
        const LibraryFolder folder;
        const auto database = withTable(folder);
        using Limits = std::numeric_limits<double>;
        std::vector<double> numbers{0.1,
                                    1.0 / 3,
                                    -2.0 / 3,
                                    5e-324,
                                    -5e-324,
                                    Limits::min(),
                                    Limits::max(),
                                    -Limits::max(),
                                    Limits::epsilon(),
                                    123456789012345678.0,
                                    9007199254740993.0,
                                    1e22,
                                    1e23,
                                    4503599627370497.5};
        quint64 bits = 88172645463325252u;
        while (numbers.size() < 500) {
            bits ^= bits << 13;
            bits ^= bits >> 7;
            bits ^= bits << 17;
            if (const auto number = std::bit_cast<double>(bits); std::isfinite(number))
                numbers.push_back(number);
        }
        const auto transaction = valueOf(Transaction::begin(*database, u"test"_s));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            Statement row(*database, u"test"_s, u"INSERT INTO kept (id, d, n) VALUES (?, ?, ?)"_s);
            row.bind(u"%1"_s.arg(qint64(i), 6, 10, QLatin1Char('0'))).bind(numbers[i]);
            valueOf(row.bind(std::bit_cast<qint64>(numbers[i])).run());
        }
        Statement query(*database, u"test"_s, u"SELECT d, n FROM kept ORDER BY id"_s);
        std::size_t i = 0;
        valueOf(query.forEach([&](Statement& row) {
            const double number = row.takeReal();
            QCOMPARE(std::bit_cast<quint64>(number), std::bit_cast<quint64>(numbers[i]));
            QCOMPARE(row.takeInteger(), std::bit_cast<qint64>(numbers[i]));
            ++i;
        }));
        QCOMPARE(i, numbers.size());
    }

    void nothingIsNeitherZeroNorEmpty()
    {
        const LibraryFolder folder;
        const auto database = withTable(folder);
        Statement row(*database, u"test"_s, u"INSERT INTO kept (id, n, d, t, b) VALUES ('a', ?, ?, ?, ?)"_s);
        row.bindOptional(std::optional<qint64>()).bind(std::optional<double>());
        valueOf(row.bindOptional(std::optional<QString>()).bindBytes(QByteArray("")).run());
        Statement query(*database, u"test"_s, u"SELECT n, d, t, b FROM kept"_s);
        valueOf(query.forEach([](Statement& found) {
            QVERIFY(!found.takeOptionalInteger());
            QVERIFY(!found.takeOptionalReal());
            QVERIFY(!found.takeOptionalText());
            const QByteArray bytes = found.takeBytes();
            QVERIFY(bytes.isEmpty());
        }));
    }

    void infinitiesAndNoNumberAreNoNumbersToCountWith()
    {
        const LibraryFolder folder;
        const auto database = withTable(folder);
        using Limits = std::numeric_limits<double>;
        for (const double number : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
            Statement row(*database, u"test"_s, u"INSERT INTO kept (id, d) VALUES (?, ?)"_s);
            valueOf(row.bind(QString::number(number)).bind(number).run());
        }
        Statement query(*database, u"test"_s, u"SELECT d FROM kept"_s);
        int rows = 0;
        valueOf(query.forEach([&](Statement& found) {
            QVERIFY(!found.takeOptionalReal());
            ++rows;
        }));
        QCOMPARE(rows, 3);
    }

    void everySignOfUnicodeComesBackAndTextsAreOrderedByTheirBytes()
    {
        const LibraryFolder folder;
        const auto database = withTable(folder);
        QStringList texts;
        for (const char32_t first : {0x1u, 0x20u, 0x400u, 0x2000u, 0xe000u, 0x1f600u, 0x10ff00u}) {
            QString text;
            for (char32_t sign = first; sign < first + 256; ++sign)
                text += QString::fromUcs4(&sign, 1);
            texts << text;
        }
        texts << u"'"_s << u"\\'\\\\"_s << u"a?b"_s << u"%1"_s << u"$1"_s << u"\r\n\t"_s << u"Z"_s << u"a"_s
              << u"Ä"_s << u"-a"_s << u"_"_s << u"a b"_s << u"a-b"_s << u"ab"_s;
        for (const QString& text : texts) {
            Statement row(*database, u"test"_s, u"INSERT INTO kept (id, t) VALUES (?, ?)"_s);
            valueOf(row.bind(text).bind(text).run());
        }
        std::sort(texts.begin(), texts.end(),
                  [](const QString& a, const QString& b) { return a.toUtf8() < b.toUtf8(); });
        QStringList found;
        Statement query(*database, u"test"_s, u"SELECT t FROM kept ORDER BY id"_s);
        valueOf(query.forEach([&](Statement& row) { found << row.takeText(); }));
        QCOMPARE(found, texts);
    }

    void bytesComeBack()
    {
        const LibraryFolder folder;
        const auto database = withTable(folder);
        QByteArray bytes;
        for (int i = 0; i < 100'000; ++i)
            bytes += char(i * 7 + i / 256);
        Statement row(*database, u"test"_s, u"INSERT INTO kept (id, b) VALUES ('a', ?)"_s);
        valueOf(row.bindBytes(bytes).run());
        Statement query(*database, u"test"_s, u"SELECT b FROM kept"_s);
        valueOf(query.forEach([&](Statement& found) { QCOMPARE(found.takeBytes(), bytes); }));
    }

    void aTextContainsAnotherWhateverTheCaseOfAToZ()
    {
        const LibraryFolder folder;
        const auto database = withTable(folder);
        Statement row(*database, u"test"_s, u"INSERT INTO kept (id, t) VALUES ('a', 'Große ÄPFEL 50%')"_s);
        valueOf(row.run());
        const auto contains = [&](const QString& pattern) {
            int rows = 0;
            Statement query(*database, u"test"_s,
                            u"SELECT id FROM kept WHERE "_s + Database::containsSql(u"t"_s));
            valueOf(query.bind(u'%' + pattern + u'%').forEach([&](Statement&) { ++rows; }));
            return rows == 1;
        };
        QVERIFY(contains(u"GRO"_s) && contains(u"pfel"_s) && contains(u"50!%"_s));
        QVERIFY(!contains(u"äpfel"_s) && !contains(u"5!%"_s));
    }

    void aCursorGivesManyRowsInOrderAndBeginsAnew()
    {
        const LibraryFolder folder;
        const auto database = withTable(folder);
        constexpr int rows = 3000; // more than are fetched at once
        {
            const auto transaction = valueOf(Transaction::begin(*database, u"test"_s));
            for (int i = 0; i < rows; ++i) {
                Statement row(*database, u"test"_s, u"INSERT INTO kept (id, n, d) VALUES (?, ?, ?)"_s);
                valueOf(row.bind(u"it's %1"_s.arg(qint64(i), 6, 10, QLatin1Char('0')))
                            .bind(i)
                            .bind(i / 3.0)
                            .run());
            }
            valueOf(transaction->commit());
        }
        const auto oneState = valueOf(ReadTransaction::begin(*database, u"test"_s));
        RowCursor cursor = valueOf(RowCursor::open(
            *database, u"test"_s, u"SELECT id, n, d, t, b FROM kept WHERE id >= ? ORDER BY id"_s));
        for (const int first : {0, 2990, 10}) {
            cursor.restart({u"it's %1"_s.arg(first, 6, 10, QLatin1Char('0')).toStdString()});
            int next = first;
            for (; cursor.next(); ++next) {
                QCOMPARE(cursor.integer(1), next);
                QCOMPARE(cursor.real(2), next / 3.0);
                QCOMPARE(cursor.text(0), u"it's %1"_s.arg(next, 6, 10, QLatin1Char('0')).toStdString());
                QVERIFY(cursor.text(3).empty() && std::isnan(cursor.real(3)));
                if (first == 10 && next == 20)
                    break;
            }
            QVERIFY(!cursor.error());
            QCOMPARE(next, first == 10 ? 20 : rows);
        }
    }
};

GRIPSCOPE_TEST(StoredValuesTest)
#include "stored_values_test.moc"
