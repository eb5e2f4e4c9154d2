// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/ledger_link.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/ledger/row_digest.h"
#include "core/library/ledger/station_key.h"
#include "core/library/migrations/migration.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTest>

#include <set>

using namespace gripscope;
using namespace gripscope::test;

namespace {

QByteArray digestOfOne(const Cell& value, const Cell& fallback = {})
{
    return rowDigest({{u"c"_s, fallback}}, {value});
}

} // namespace

/// What the ledger is made of: which rows, which bytes, which key.
class LedgerTest : public QObject {
    Q_OBJECT
private slots:
    void everyTableEntersIt()
    {
        const LibraryFolder folder;
        static_cast<void>(folder.open());
        std::set<QString> tables;
        for (const QString& table : valueOf(valueOf(Database::open(folder.file()))->tables()))
            if (!table.startsWith("sqlite_"_L1) && table != "ledger"_L1 && !table.startsWith("merged_"_L1))
                tables.insert(table);
        std::set<QString> entered;
        std::set<quint8> codes;
        for (const LedgeredTable& table : ledgeredTables()) {
            entered.insert(table.name);
            codes.insert(table.code);
        }
        QCOMPARE(entered, tables);
        QCOMPARE(codes.size(), entered.size());
        for (const QString& table : tables)
            QCOMPARE(ledgeredTable(ledgeredTable(table)->code), ledgeredTable(table));
        // Whatever a later step puts in has to be entered by it.
        for (const Migration& step : migrations())
            QVERIFY(step.version < 12 || step.afterwards);
    }
    void eachTransactionIsOneLinkOverItsRows()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        RawDatabase raw(folder.file());
        const qint64 links = raw.count(u"ledger"_s); // the schema: one for each step from the ledger on
        valueOf(library->addInspection(anInspection()));
        QCOMPARE(raw.count(u"ledger"_s), links + 1);
        const auto leaves = unpackedLeaves(
            raw.run(u"SELECT leaves FROM ledger ORDER BY number DESC LIMIT 1"_s).toByteArray());
        QVERIFY(leaves);
        std::multiset<QString> tables;
        for (const LedgerLeaf& leaf : *leaves)
            tables.insert(ledgeredTable(leaf.table)->name);
        const std::multiset<QString> expected{
            u"grasps"_s,    u"recordings"_s,  u"estimates"_s,         u"estimates"_s,
            u"documents"_s, u"inspections"_s, u"inspection_tallies"_s}; // the first of all makes one
        QCOMPARE(tables, expected);
    }
    void whatIsRolledBackIsNotInIt()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        RawDatabase raw(folder.file());
        const qint64 schema = raw.count(u"ledger"_s);
        NewInspection refused = anInspection();
        refused.batchId = u"there is no such batch"_s;
        QVERIFY(!library->addInspection(refused));
        QCOMPARE(raw.count(u"ledger"_s), schema);
        QCOMPARE(raw.count(u"grasps"_s), 0);
    }
    void aRowsDigestIsOfItsTypedValues()
    {
        const std::vector<Cell> different{Cell{},      qint64(0),       qint64(1),       0.5,
                                          u"1"_s,      u""_s,           QByteArray("1"), QByteArray(""),
                                          u"\u00e4"_s, QByteArray("ä"), 1e300,           qint64(-1)};
        std::set<QByteArray> digests;
        for (const Cell& value : different)
            digests.insert(digestOfOne(value, u"another"_s));
        QCOMPARE(digests.size(), different.size());
        QCOMPARE(digestOfOne(0.0, u""_s), digestOfOne(-0.0, u""_s));
        // Nothing can be moved from one column to the next.
        const std::vector<Column> two{{u"a"_s, {}}, {u"b"_s, {}}};
        QVERIFY(rowDigest(two, {u"xy"_s, u"z"_s}) != rowDigest(two, {u"x"_s, u"yz"_s}));
        QVERIFY(rowDigest(two, {u"x"_s, Cell{}}) != rowDigest(two, {Cell{}, u"x"_s}));
    }
    void aColumnOfALaterSchemaChangesNoDigest()
    {
        const std::vector<Column> before{{u"a"_s, {}}, {u"c"_s, {}}};
        for (const Cell& fallback : {Cell{}, Cell{u""_s}, Cell{qint64(0)}}) {
            const std::vector<Column> after{{u"a"_s, {}}, {u"b"_s, fallback}, {u"c"_s, {}}};
            QCOMPARE(rowDigest(after, {u"x"_s, fallback, 1.5}), rowDigest(before, {u"x"_s, 1.5}));
            QVERIFY(rowDigest(after, {u"x"_s, u"y"_s, 1.5}) != rowDigest(before, {u"x"_s, 1.5}));
        }
        // The column keeps 0.0 where its default is spelled 0.
        QCOMPARE(digestOfOne(0.0, qint64(0)), rowDigest({}, {}));
    }
    void leavesComeBackAsTheyWere()
    {
        const QByteArray digest = digestOf("x");
        const std::vector<LedgerLeaf> leaves{{1, qint64(12), digest},
                                             {2, u"0190a5b2-7c3e-7def-8123-456789abcdef"_s, digest},
                                             {3, u"0190A5B2-7C3E-7DEF-8123-456789ABCDEF"_s, digest},
                                             {4, u"Zoë"_s, digest},
                                             {5, u""_s, digest}};
        const QByteArray bytes = packed(leaves);
        QCOMPARE(unpackedLeaves(bytes), std::optional(leaves));
        for (qsizetype cut = 1; cut < bytes.size(); ++cut)
            if (const auto part = unpackedLeaves(bytes.first(cut)))
                QVERIFY(part->size() < leaves.size());
        QVERIFY(!unpackedLeaves(QByteArray("\1t\xff\xff\xff\xff\xff\xff\xff\xff", 10)));
    }
    void aLinksHashIsOfAllThatIsInIt()
    {
        const LedgerLink link{u"s/1"_s, 7, LedgerKind::Written, 1, u"2026"_s, "l", "p", {}, "k", {}};
        std::set<QByteArray> hashes{linkHash(link, "s"), linkHash(link, "t")};
        const auto change = [&](auto changed) {
            LedgerLink other = link;
            changed(other);
            hashes.insert(linkHash(other, "s"));
        };
        change([](LedgerLink& l) { l.chain = u"s/2"_s; });
        change([](LedgerLink& l) { l.number = 8; });
        change([](LedgerLink& l) { l.kind = LedgerKind::Found; });
        change([](LedgerLink& l) { l.format = 2; });
        change([](LedgerLink& l) { l.utc = u"2027"_s; });
        change([](LedgerLink& l) { l.leaves = "m"; });
        change([](LedgerLink& l) { l.previousHash = "q"; });
        change([](LedgerLink& l) { l.signer = "j"; });
        QCOMPARE(hashes.size(), std::size_t(10));
    }
    void theStationsKeyIsMadeOnceAndItsAlone()
    {
        const auto key = StationKey::own();
        QVERIFY(key);
        QCOMPARE(StationKey::own()->publicKey(), key->publicKey());
        const QFileInfo file(StationKey::file());
        QCOMPARE(file.size(), 32);
        QVERIFY(!(file.permissions() & (QFileDevice::ReadGroup | QFileDevice::ReadOther)));
        const QByteArray signature = key->sign("text");
        QVERIFY(isSignedBy(key->publicKey(), "text", signature));
        QVERIFY(!isSignedBy(key->publicKey(), "another", signature));
        QVERIFY(!isSignedBy(key->publicKey().left(31), "text", signature));
        QVERIFY(!isSignedBy(key->publicKey(), "text", {}));
        // RFC 8032, section 7.1, test 1: the key of a known seed, and its signature of nothing.
        std::array<unsigned char, 32> seed{};
        const QByteArray known =
            QByteArray::fromHex("9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60");
        std::copy(known.begin(), known.end(), seed.begin());
        const StationKey stated(seed);
        QCOMPARE(stated.publicKey().toHex(),
                 "d75a980182b10ab7d54bfed3c964073a0ee172f3daa62325af021a68f707511a"_ba);
        QCOMPARE(stated.sign({}).toHex(), "e5564300c360ac729086e2cc806e828a84877f1eb8e5d974d873e065224901555f"
                                          "b8821590a33bacc61e39701cf9b46bd"
                                          "25bf5f0595bbe24655141438e7a100b"_ba);
    }
};

GRIPSCOPE_TEST(LedgerTest)
#include "ledger_test.moc"
