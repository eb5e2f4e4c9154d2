// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/audit_chain.h"
#include "tests/support/test_registry.h"

#include <QCryptographicHash>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

AuditEntry entryAfter(const AuditEntry* before, const QString& subject)
{
    AuditEntry entry;
    entry.number = before ? before->number + 1 : 1;
    entry.utc = u"2026-01-01T12:00:00.000Z"_s;
    entry.station = u"line-1"_s;
    entry.person = u"Zoë"_s;
    entry.role = u"supervisor"_s;
    entry.action = u"type.approve"_s;
    entry.subject = subject;
    entry.details = u"{\"version\":1}"_s;
    entry.previousHash = before ? before->hash : firstPreviousHash();
    entry.hash = auditHash(entry);
    return entry;
}

std::vector<AuditEntry> trail(int length)
{
    std::vector<AuditEntry> entries;
    for (int i = 0; i < length; ++i)
        entries.push_back(entryAfter(entries.empty() ? nullptr : &entries.back(), QString::number(i)));
    return entries;
}

AuditVerification verify(const std::vector<AuditEntry>& entries, std::optional<AuditHead> witness = {})
{
    AuditChainCheck check(std::move(witness));
    for (const AuditEntry& entry : entries)
        check.take(entry);
    return check.finish();
}

} // namespace

/// Every kind of tampering is found at its first entry.
class AuditChainTest : public QObject {
    Q_OBJECT
private slots:
    void theHashIsOfTheDocumentedBytes()
    {
        const AuditEntry entry = trail(1).front();
        QByteArray bytes;
        for (const QString& text :
             {u"gripscope-audit-1"_s, QString(64, u'0'), u"1"_s, entry.utc, entry.station, entry.person,
              entry.role, entry.action, entry.subject, entry.reason, entry.details})
            bytes += QByteArray(7, '\0') + static_cast<char>(text.toUtf8().size()) + text.toUtf8();
        QCOMPARE(entry.hash,
                 QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex()));
    }
    void textThatMovesToTheNextFieldIsAnotherEntry()
    {
        AuditEntry one = trail(1).front();
        AuditEntry other = one;
        one.subject = u"ab"_s;
        one.reason = u"c"_s;
        other.subject = u"a"_s;
        other.reason = u"bc"_s;
        QVERIFY(auditHash(one) != auditHash(other));
    }
    void aWholeTrailIsWhole()
    {
        const auto found = verify(trail(5));
        QVERIFY(found.whole());
        QCOMPARE(found.head.entries, 5);
        QVERIFY(verify({}).whole());
    }
    void everyFieldCounts_data()
    {
        QTest::addColumn<int>("field");
        for (int field = 0; field < 9; ++field)
            QTest::addRow("field %d", field) << field;
    }
    void everyFieldCounts()
    {
        QFETCH(int, field);
        auto entries = trail(5);
        AuditEntry& entry = entries[2];
        QString* const texts[] = {&entry.utc,    &entry.station, &entry.person,
                                  &entry.role,   &entry.action,  &entry.subject,
                                  &entry.reason, &entry.details, &entry.previousHash};
        *texts[field] += u'x';
        const auto found = verify(entries);
        QCOMPARE(int(found.fault), int(AuditFault::Changed));
        QCOMPARE(found.at, 3);
    }
    void aChangedEntryWithANewHashBreaksTheLink()
    {
        auto entries = trail(5);
        entries[2].reason = u"another"_s;
        entries[2].hash = auditHash(entries[2]);
        const auto found = verify(entries);
        QCOMPARE(int(found.fault), int(AuditFault::Unlinked));
        QCOMPARE(found.at, 4);
    }
    void aMissingOrExchangedEntryIsFound()
    {
        auto entries = trail(5);
        entries.erase(entries.begin() + 1);
        QCOMPARE(int(verify(entries).fault), int(AuditFault::Missing));
        QCOMPARE(verify(entries).at, 3);
        entries = trail(5);
        std::swap(entries[1], entries[2]);
        QCOMPARE(int(verify(entries).fault), int(AuditFault::Missing));
        entries = trail(5);
        std::swap(entries[1].number, entries[2].number);
        std::swap(entries[1], entries[2]); // read in the order of their numbers
        QCOMPARE(int(verify(entries).fault), int(AuditFault::Changed));
        QCOMPARE(verify(entries).at, 2);
    }
    void aCutEndIsKnownToTheSecondPlaceOnly()
    {
        const auto entries = trail(5);
        const AuditHead witness{5, entries[4].hash};
        const std::vector<AuditEntry> cut(entries.begin(), entries.begin() + 3);
        QVERIFY(verify(cut).whole());
        QVERIFY(!verify(cut).witnessed);
        QCOMPARE(int(verify(cut, witness).fault), int(AuditFault::CutShort));
        QCOMPARE(verify(cut, witness).at, 4);
        QVERIFY(verify(entries, witness).whole() && verify(entries, witness).witnessed);
        QVERIFY(verify(entries, AuditHead{3, entries[2].hash}).whole()); // written on from elsewhere
    }
    void aTrailMadeAnewIsKnownToTheSecondPlaceOnly()
    {
        const AuditHead witness{3, trail(3)[2].hash};
        std::vector<AuditEntry> anew;
        for (int i = 0; i < 4; ++i)
            anew.push_back(entryAfter(anew.empty() ? nullptr : &anew.back(), u"forged"_s));
        QVERIFY(verify(anew).whole());
        QCOMPARE(int(verify(anew, witness).fault), int(AuditFault::Replaced));
        QCOMPARE(verify(anew, witness).at, 3);
    }
    void everyFindingIsWorded()
    {
        for (const AuditFault fault : {AuditFault::Missing, AuditFault::Unlinked, AuditFault::Changed,
                                       AuditFault::CutShort, AuditFault::Replaced}) {
            AuditVerification found;
            found.fault = fault;
            found.at = 17;
            QVERIFY(!toString(fault).isEmpty());
            QVERIFY(inWords(found).contains(u"17"_s) && inWords(found).contains(u"not in order"_s));
        }
        QVERIFY(inWords(verify(trail(2))).startsWith(u"All 2 entries are as they were written"_s));
    }
};

GRIPSCOPE_TEST(AuditChainTest)
#include "audit_chain_test.moc"
