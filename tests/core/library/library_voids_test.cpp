// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/history/history_fields.h"
#include "core/library/migrations/migration.h"
#include "core/library/records/batch.h"
#include "core/library/records/history.h"
#include "core/library/verification/library_verification.h"
#include "core/people/audit_entry.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;

namespace {

qint64 inspected(Library& library, const QString& batchId = {}, VerdictKind kind = VerdictKind::Type,
                 const QString& part = {})
{
    NewInspection inspection = anInspection(kind, u"A"_s);
    inspection.expectedType = u"A"_s;
    inspection.batchId = batchId;
    inspection.partNumber = part;
    return valueOf(library.addInspection(inspection)).number;
}

HistoryEntry entryOf(Library& library, qint64 number)
{
    const HistoryKeys keys = valueOf(library.historyKeys({}));
    for (const HistoryEntry& entry : valueOf(library.historyEntries(keys.part(0, keys.size()))))
        if (entry.number == number)
            return entry;
    return {};
}

} // namespace

/// Inspections that do not count, part numbers, and what is counted from a number on.
class LibraryVoidsTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsVoidedCountsNowhere()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const BatchRecord batch = valueOf(library->beginBatch({u"4711"_s, 3, u"A"_s, u"Ada"_s}));
        inspected(*library, batch.id);
        const qint64 twice = inspected(*library, batch.id);
        valueOf(library->voidInspection(twice, u" squeezed twice "_s, u"Ada"_s));
        valueOf(library->voidInspection(twice, u"again"_s, u"Bob"_s)); // and nothing is changed
        for (const InspectionCounts& counts :
             {valueOf(library->inspectionCounts()), valueOf(library->batchUnderWay())->counts}) {
            QCOMPARE(counts.total, 1);
            QCOMPARE(counts.asExpected, 1);
            QCOMPARE(counts.voided, 1);
            QCOMPARE(counts.expected.value(u"A"_s).squeezes, 1);
            QCOMPARE(counts.expected.value(u"A"_s).asExpected(), 1);
        }
        const HistoryCounts counts = valueOf(library->historyCounts({}));
        QCOMPARE(counts.inspections, 2); // it is still there
        QCOMPARE(counts.asExpected, 1);
        QCOMPARE(counts.voided, 1);
        QCOMPARE(valueOf(library->historyPoints(HistoryQuery{})).points.size(), std::size_t(1));
    }
    void aVoidIsARowMore()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const qint64 number = inspected(*library);
        valueOf(library->voidInspection(number, u"nothing in the jaws"_s, u"Ada"_s));
        RawDatabase raw(folder.file());
        QCOMPARE(raw.count(u"inspections"_s), 1);
        QCOMPARE(raw.count(u"inspection_voids"_s), 1);
        const AuditEntry told = valueOf(library->auditTrail().entries({})).front();
        QCOMPARE(told.action, QString::fromUtf16(audit_action::inspectionVoided));
        QCOMPARE(told.subject, QString::number(number));
        QCOMPARE(told.reason, u"nothing in the jaws"_s);
        QVERIFY(actionInWords(told.action) != told.action);
        QCOMPARE(valueOf(library->inspections({})).front().voided, u"nothing in the jaws"_s);
        QCOMPARE(entryOf(*library, number).voided, u"nothing in the jaws"_s);
        QCOMPARE(factsOf(HistoryColumn::Voided).value(entryOf(*library, number)).toString(),
                 u"nothing in the jaws"_s);
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void whatIsNoVoidIsRefused()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const qint64 number = inspected(*library);
        QCOMPARE(library->voidInspection(number, u"  "_s, u"Ada"_s).error().code, ErrorCode::Usage);
        QCOMPARE(library->voidInspection(number + 1, u"why"_s, u"Ada"_s).error().code, ErrorCode::NotFound);
        QCOMPARE(valueOf(library->inspectionCounts()).total, 1);
    }
    void countsFromANumberOn()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        inspected(*library);
        const qint64 last = inspected(*library, {}, VerdictKind::Inconclusive);
        const qint64 voided = inspected(*library);
        inspected(*library);
        valueOf(library->voidInspection(voided, u"why"_s, {}));
        const InspectionCounts shift = valueOf(library->inspectionCounts(last));
        QCOMPARE(shift.total, 1);
        QCOMPARE(shift.judged(), 1);
        QCOMPARE(shift.voided, 1);
        const InspectionCounts all = valueOf(library->inspectionCounts());
        QCOMPARE(all.total, 3);
        QCOMPARE(all.expected.value(u"A"_s).inconclusive, 1);
        QCOMPARE(all.expected.value(u"A"_s).judged(), 2);
    }
    void aPartNumberIsKeptAndFound()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const qint64 number = inspected(*library, {}, VerdictKind::Type, u"SN 0042"_s);
        inspected(*library);
        QCOMPARE(entryOf(*library, number).partNumber, u"SN 0042"_s);
        QCOMPARE(valueOf(library->inspections({})).back().partNumber, u"SN 0042"_s);
        QCOMPARE(valueOf(library->historyKeys({.text = u"sn 00"_s})).size(), std::size_t(1));
        for (const HistoryField& field : historyFields())
            if (QByteArray(field.json) == "part_number")
                QCOMPARE(field.cells(entryOf(*library, number)), QStringList{u"SN 0042"_s});
    }
    void aLibraryOfTheStepBeforeGetsThem()
    {
        const LibraryFolder folder;
        {
            const std::vector<Migration> before = migrationsUpTo(14);
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, before));
            QVERIFY(!valueOf(database->tables()).contains(u"inspection_voids"_s));
        }
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        valueOf(library->voidInspection(inspected(*library), u"why"_s, {}));
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
};

GRIPSCOPE_TEST(LibraryVoidsTest)
#include "library_voids_test.moc"
