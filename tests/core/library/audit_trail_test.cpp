// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/ledger/library_witness.h"
#include "tests/core/library/child_process.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A library with a trail of five entries.
struct Trail {
    LibraryFolder folder;
    std::unique_ptr<Library> library = folder.open();
    QString typeId = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s, u"Mai"_s)).id;
    Trail()
    {
        for (int i = 0; i < 3; ++i)
            valueOf(library->addGrasp(aGrasp(typeId)));
        valueOf(library->approveType(typeId, u"Mai"_s));
    }

    [[nodiscard]] AuditVerification verify() const { return valueOf(library->auditTrail().verify()); }
    void tamper(const QString& sql) const { RawDatabase(folder.file()).run(sql); }
    /// What somebody does who knows how the hashes are made.
    void makeAnew(qint64 from) const
    {
        auto entries = valueOf(library->auditTrail().entries({}));
        std::reverse(entries.begin(), entries.end());
        QString previous = from > 1 ? entries[std::size_t(from - 2)].hash : firstPreviousHash();
        for (auto entry = entries.begin() + from - 1; entry != entries.end(); ++entry) {
            entry->previousHash = previous;
            previous = auditHash(*entry);
            tamper(u"UPDATE audit_entries SET previous_hash = '%1', hash = '%2' WHERE number = %3"_s
                       .arg(entry->previousHash, previous)
                       .arg(entry->number));
        }
    }
};

} // namespace

/// The trail is written with what it tells of, and tampering is found.
class AuditTrailTest : public QObject {
    Q_OBJECT
private slots:
    void aClockThatWasSetBackIsTold()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString typeId = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s, u"Mai"_s)).id;
        RawDatabase raw(folder.file());
        // Made while the clock was ahead; its hash no longer fits, which is another matter.
        raw.run(u"UPDATE audit_entries SET created_utc = '2099-01-01T00:00:00.000Z'"_s);
        valueOf(library->approveType(typeId, u"Mai"_s));
        auto entries = valueOf(library->auditTrail().entries({}));
        QCOMPARE(entries.size(), std::size_t(3));
        QCOMPARE(entries[1].action, u"clock.back"_s);
        QVERIFY(entries[1].details.contains(u"2099"_s));
        QCOMPARE(actionInWords(entries[1].action), u"Clock was set back"_s);
        valueOf(library->addGrasp(aGrasp(typeId))); // once for each step
        QCOMPARE(valueOf(library->auditTrail().count({})), 4);
    }
    void changesAreToldWithWhoWhenAndWhy()
    {
        const Trail trail;
        const auto entries = valueOf(trail.library->auditTrail().entries({}));
        QCOMPARE(entries.size(), std::size_t(5));
        QCOMPARE(entries[0].action, u"type.approve"_s);
        QCOMPARE(entries[0].person, u"Mai"_s);
        QCOMPARE(entries[0].role, QString()); // nobody has to sign in
        QCOMPARE(entries[0].subject, u"A"_s);
        QCOMPARE(entries[0].number, 5);
        QVERIFY(QDateTime::fromString(entries[0].utc, Qt::ISODateWithMs).isValid());
        QCOMPARE(entries[4].action, u"type.new_type"_s);
        valueOf(trail.library->retireType(trail.typeId, {u"Ada"_s, u"out of production"_s}));
        QCOMPARE(valueOf(trail.library->auditTrail().entries({{}, {}, 1, 0})).front().reason,
                 u"out of production"_s);
    }
    void exportsAndReasonsAreTold()
    {
        const Trail trail;
        valueOf(trail.library->tellExport(u"/tmp/all.csv"_s, u"csv"_s, 12));
        AuditEntry newest = valueOf(trail.library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(newest.action, u"export.made"_s);
        QCOMPARE(newest.subject, u"/tmp/all.csv"_s);
        QVERIFY(newest.details.contains(u"\"rows\":12"_s));
        valueOf(trail.library->approveType(trail.typeId, u"Mai"_s, u"as the drawing says"_s));
        newest = valueOf(trail.library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(newest.action, u"type.approve"_s);
        QCOMPARE(newest.reason, u"as the drawing says"_s);
        valueOf(trail.library->auditTrail().record(Permission::ChangeSettings, u"captures.pruned"_s,
                                                   u"folder"_s, {}, u"full"_s));
        newest = valueOf(trail.library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(newest.reason, u"full"_s);
        for (const auto& action :
             {u"export.made"_s, u"captures.pruned"_s, u"profile.installed"_s, u"batch.begun"_s})
            QVERIFY(actionInWords(action) != action);
    }
    void itIsFilteredAndPaged()
    {
        const Trail trail;
        const AuditTrail audit = trail.library->auditTrail();
        QCOMPARE(valueOf(audit.count({})), 5);
        QCOMPARE(valueOf(audit.count({{}, u"type.squeeze"_s})), 3);
        QCOMPARE(valueOf(audit.count({u"mAI"_s, u"type."_s})), 2); // the squeezes are Ada's
        QCOMPARE(valueOf(audit.count({u"100%"_s, {}})), 0);        // no wildcard
        QCOMPARE(valueOf(audit.count({u"_"_s, u"sign_"_s})), 0);
        const auto page = valueOf(audit.entries({{}, {}, 2, 3}));
        QCOMPARE(page.size(), std::size_t(2));
        QCOMPARE(page[0].number, 2);
    }
    void aWholeTrailIsWholeAndKnownHere()
    {
        const Trail trail;
        const auto found = trail.verify();
        QVERIFY(found.whole() && found.witnessed);
        QCOMPARE(found.head.entries, 5);
        QVERIFY(QFile::exists(found.witness));
    }
    void tamperingIsFound_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("at");
        QTest::newRow("a changed reason")
            << u"UPDATE audit_entries SET reason = 'x' WHERE number = 3"_s << int(AuditFault::Changed) << 3;
        QTest::newRow("a changed time") << u"UPDATE audit_entries SET created_utc = '2020' WHERE number = 1"_s
                                        << int(AuditFault::Changed) << 1;
        QTest::newRow("a deleted row")
            << u"DELETE FROM audit_entries WHERE number = 2"_s << int(AuditFault::Missing) << 3;
        QTest::newRow("the first deleted")
            << u"DELETE FROM audit_entries WHERE number = 1"_s << int(AuditFault::Missing) << 2;
        QTest::newRow("moved to the end")
            << u"UPDATE audit_entries SET number = CASE number WHEN 2 THEN 103 WHEN 3 THEN "
               "102 ELSE number END; "_s
            << int(AuditFault::Missing) << 4;
        QTest::newRow("put in") << u"INSERT INTO audit_entries SELECT 6, station, created_utc, person, role, "
                                   "action, subject, reason, details, previous_hash, hash FROM audit_entries "
                                   "WHERE number = 5"_s
                                << int(AuditFault::Changed) << 6;
        QTest::newRow("the end cut off")
            << u"DELETE FROM audit_entries WHERE number > 3"_s << int(AuditFault::CutShort) << 4;
        QTest::newRow("all deleted") << u"DELETE FROM audit_entries"_s << int(AuditFault::CutShort) << 1;
    }
    void tamperingIsFound()
    {
        QFETCH(QString, sql);
        QFETCH(int, fault);
        QFETCH(int, at);
        const Trail trail;
        trail.tamper(sql);
        const auto found = trail.verify();
        QCOMPARE(int(found.fault), fault);
        QCOMPARE(found.at, at);
    }
    void aChainThatIsMadeAnewIsFoundByTheSecondPlace()
    {
        const Trail trail;
        trail.tamper(u"UPDATE audit_entries SET person = 'Eve' WHERE number = 2"_s);
        trail.makeAnew(2);
        QCOMPARE(int(trail.verify().fault), int(AuditFault::Replaced));
        QFile::remove(witnessFile(trail.folder.file()));
        const auto elsewhere = trail.verify(); // on another computer it cannot be seen, and that is said
        QVERIFY(elsewhere.whole() && !elsewhere.witnessed);
        QVERIFY(inWords(elsewhere).contains(u"cannot be told"_s));
    }
    void evidenceIsNotOverwrittenByWhatComesLater()
    {
        const Trail trail;
        trail.tamper(u"DELETE FROM audit_entries WHERE number > 3"_s);
        for (int i = 0; i < 4; ++i)
            valueOf(trail.library->addGrasp(aGrasp(trail.typeId)));
        QCOMPARE(int(trail.verify().fault), int(AuditFault::Replaced));
        QCOMPARE(trail.verify().at, 5);
    }
    void whatIsNotStoredIsNotTold()
    {
        const Trail trail;
        QVERIFY(!trail.library->renameType(trail.typeId, u"B"_s, {u"Mai"_s, {}})); // no reason
        QVERIFY(!trail.library->addGrasp([&] {
            NewGrasp grasp = aGrasp(trail.typeId);
            grasp.forceUnit = u"1"_s;
            return grasp;
        }()));
        QCOMPARE(trail.verify().head.entries, 5);
        QVERIFY(trail.verify().whole());
    }
    void aWriterThatIsKilledLeavesTheChainWhole()
    {
        const Trail trail;
        qint64 before = 5;
        for (int round = 0; round < 6; ++round) {
            int ready[2];
            QCOMPARE(pipe(ready), 0);
            const pid_t writer = startChild([&] {
                const auto library = valueOf(Library::open(trail.folder.file()));
                while (true) {
                    valueOf(library->approveType(trail.typeId, u"Mai"_s));
                    if (write(ready[1], "x", 1) != 1)
                        _exit(1);
                }
            });
            close(ready[1]);
            char byte = 0;
            QCOMPARE(read(ready[0], &byte, 1), 1);
            QTest::qSleep(round); // so that the kill falls at other points of a write
            ::kill(writer, SIGKILL);
            waitpid(writer, nullptr, 0);
            close(ready[0]);
            const auto found = trail.verify();
            QVERIFY2(found.whole(), qPrintable(inWords(found)));
            QVERIFY(found.head.entries > before);
            before = found.head.entries;
            // As many approvals as versions of the library: none is told of twice or not at all.
            QCOMPARE(valueOf(trail.library->version()), before);
        }
    }
    void twoProcessesWriteOneChain()
    {
        const Trail trail;
        std::vector<pid_t> writers;
        for (int i = 0; i < 2; ++i)
            writers.push_back(startChild([&] {
                const auto library = valueOf(Library::open(trail.folder.file()));
                for (int n = 0; n < 10; ++n)
                    valueOf(library->approveType(trail.typeId, u"Mai"_s));
            }));
        for (const pid_t writer : writers)
            QVERIFY(endedWell(writer));
        const auto found = trail.verify();
        QVERIFY2(found.whole(), qPrintable(inWords(found)));
        QCOMPARE(found.head.entries, 25);
    }
};

GRIPSCOPE_TEST(AuditTrailTest)
#include "audit_trail_test.moc"
