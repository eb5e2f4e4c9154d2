// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/history/history_fields.h"
#include "core/library/migrations/migration.h"
#include "core/library/spill/spilled_inspection.h"
#include "core/library/sql/database.h"
#include "core/library/tables/tally_table.h"
#include "core/library/verification/library_verification.h"
#include "core/people/audit_entry.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/people_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;

namespace {

const ChangeNote limitsBecause{u"Ada"_s, u"drawing 4711"_s};

PartLimits stiffnessBetween(double lower, double upper)
{
    PartLimits limits;
    limits.quantities[2] = ToleranceLimits{lower, upper};
    return limits;
}

/// An inspection of A, which was expected, whose k was found so.
NewInspection inspectionOf(double k, double u = 10)
{
    NewInspection inspection = anInspection();
    inspection.verdict.conformity = valueOf(judgeConformity(
        stiffnessBetween(9900, 10100), {std::nullopt, std::nullopt, MeasuredValue{k, u, 20.}}, 1.0));
    return inspection;
}

struct EnrolledType {
    LibraryFolder folder;
    std::unique_ptr<Library> library = folder.open();
    TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));

    EnrolledType()
    {
        for (int i = 0; i < 4; ++i)
            valueOf(library->addGrasp(aGrasp(type.id, 9980 + 10 * i)));
        valueOf(library->approveType(type.id, u"Ada"_s));
    }
    TypeRecord now() const { return valueOf(library->findType(u"A"_s)).value(); }
};

} // namespace

/// Tolerance limits of types, and how inspected parts stood to them.
class LibraryLimitsTest : public QObject {
    Q_OBJECT
private slots:
    void limitsAreAVersionThatSurvivesReopening()
    {
        EnrolledType in;
        const PartLimits limits = stiffnessBetween(9900, 10100);
        const qint64 before = valueOf(in.library->version());
        QVERIFY(valueOf(in.library->setTypeLimits(in.type.id, limits, limitsBecause)).limits == limits);
        QVERIFY(in.now().approved); // nobody is there who could approve it
        QCOMPARE(valueOf(in.library->version()), before + 1);
        const LibraryChange change = valueOf(in.library->changes(1)).at(0);
        QVERIFY(change.kind == ChangeKind::Limits);
        QCOMPARE(inWords(change), u"The tolerance limits of A are k=9900:10100 rule=iso14253."_s);
        QCOMPARE(change.reason, u"drawing 4711"_s);
        const AuditEntry told = valueOf(in.library->auditTrail().entries({})).front();
        QCOMPARE(told.action, u"type.limits"_s);
        QVERIFY(actionInWords(told.action) != told.action);
        // The same again is no change.
        valueOf(in.library->setTypeLimits(in.type.id, limits, limitsBecause));
        QCOMPARE(valueOf(in.library->version()), before + 1);
        in.library.reset();
        in.library = in.folder.open();
        QVERIFY(in.now().limits == limits);
        QVERIFY(valueOf(in.library->stateAt(before)).types.at(0).limits.isEmpty());
        QVERIFY(valueOf(verifyLibrary(in.folder.file())).whole());
    }
    void anEarlierVersionBringsItsLimitsBack()
    {
        EnrolledType in;
        const qint64 without = valueOf(in.library->version());
        valueOf(in.library->setTypeLimits(in.type.id, stiffnessBetween(9900, 10100), limitsBecause));
        const qint64 first = valueOf(in.library->version());
        valueOf(in.library->setTypeLimits(in.type.id, stiffnessBetween(1, 2), limitsBecause));
        valueOf(in.library->restoreVersion(first, limitsBecause));
        QVERIFY(in.now().limits == stiffnessBetween(9900, 10100));
        valueOf(in.library->restoreVersion(without, limitsBecause));
        QVERIFY(in.now().limits.isEmpty());
        valueOf(in.library->setTypeLimits(in.type.id, stiffnessBetween(1, 2), limitsBecause));
        valueOf(in.library->setTypeLimits(in.type.id, {}, limitsBecause));
        QVERIFY(in.now().limits.isEmpty());
        QCOMPARE(inWords(valueOf(in.library->changes(1)).at(0)), u"A no longer has tolerance limits."_s);
    }
    void otherChangesKeepThem()
    {
        EnrolledType in;
        const PartLimits limits = stiffnessBetween(9900, 10100);
        valueOf(in.library->setTypeLimits(in.type.id, limits, limitsBecause));
        Recipe firmer;
        firmer.peak_N = 12;
        valueOf(in.library->reviseType(in.type.id, firmer));
        valueOf(in.library->setTypeCode(in.type.id, u"4006381"_s, limitsBecause));
        valueOf(in.library->retireType(in.type.id, limitsBecause));
        valueOf(in.library->reinstateType(in.type.id, limitsBecause));
        QVERIFY(in.now().limits == limits);
        // Those that are split off are parts of the same drawing.
        const QString key = valueOf(in.library->grasps(in.type.id)).at(0).id;
        QVERIFY(valueOf(in.library->splitType(in.type.id, {key}, u"B"_s, limitsBecause)).limits == limits);
    }
    void wherePeopleAreTheyNeedApprovalAgain()
    {
        EnrolledType in;
        const People people(*in.library);
        const PartLimits limits = stiffnessBetween(9900, 10100);
        const auto refused = in.library->setTypeLimits(in.type.id, limits, limitsBecause);
        QVERIFY(!refused && in.now().limits.isEmpty() && in.now().approved);
        in.library->actAs(people.operatorOf(*in.library));
        QVERIFY(!in.library->setTypeLimits(in.type.id, limits, limitsBecause));
        in.library->actAs(people.supervisor(*in.library));
        valueOf(in.library->setTypeLimits(in.type.id, limits, limitsBecause));
        QVERIFY(!in.now().approved && in.now().limits == limits);
        QVERIFY(valueOf(in.library->approvedSqueezes()).empty());
        valueOf(in.library->approveType(in.type.id, u"Sam"_s));
        QVERIFY(in.now().approved && in.now().limits == limits);
    }
    void refusesWhatMakesNoSense()
    {
        EnrolledType in;
        const PartLimits limits = stiffnessBetween(9900, 10100);
        QVERIFY(in.library->setTypeLimits(in.type.id, limits, {u"Ada"_s, u" "_s}).error().code ==
                ErrorCode::Usage);
        QVERIFY(in.library->setTypeLimits(in.type.id, stiffnessBetween(2, 1), limitsBecause).error().code ==
                ErrorCode::Usage);
        QVERIFY(in.library->setTypeLimits(in.type.id, stiffnessBetween(0, 1), limitsBecause).error().code ==
                ErrorCode::Usage);
        QVERIFY(in.library->setTypeLimits(u"none"_s, limits, limitsBecause).error().code ==
                ErrorCode::NotFound);
        QVERIFY(in.now().limits.isEmpty());
    }
    void theRisksAreOfItsOwnSqueezes()
    {
        EnrolledType in;
        const auto risks = valueOf(in.library->typeRisks(in.now(), stiffnessBetween(9900, 10100)));
        QVERIFY(risks[2] && !risks[0] && !risks[1]);
        QCOMPARE(risks[2]->squeezes, 4);
        QCOMPARE(risks[2]->mean, 9995.0);
        // 9980 to 10010 in steps of 10: variance 500/3, less the estimates' own 1/3.
        QVERIFY(std::abs(risks[2]->deviation - std::sqrt(500. / 3 - 1. / 3)) < 1e-9);
        QVERIFY(std::abs(risks[2]->uncertainty - std::sqrt(1. / 3)) < 1e-12);
        QVERIFY(risks[2]->risks.consumers < 1e-9 && risks[2]->risks.producers < 1e-9);
    }
    void theStoredBudgetIsWhatTheRisksGoBy()
    {
        EnrolledType in;
        NewGrasp grasp = aGrasp(in.type.id);
        const auto named = [](double k) { return QJsonObject{{u"m"_s, 0.04}, {u"b"_s, 43}, {u"k"_s, k}}; };
        grasp.identification = {{u"budget"_s, QJsonObject{{u"parameters"_s, named(10000)},
                                                          {u"standard_uncertainties"_s, named(25)},
                                                          {u"degrees_of_freedom"_s, named(7)}}}};
        valueOf(in.library->addGrasp(grasp));
        const auto measured = valueOf(in.library->measuredSqueezes(in.now()));
        QCOMPARE(measured.size(), std::size_t(5));
        QCOMPARE(measured[4][2]->value, 10000.0);
        QCOMPARE(measured[4][2]->standardUncertainty.value(), 25.0);
        QCOMPARE(measured[4][2]->degreesOfFreedom.value(), 7.0);
    }
    void aDecisionIsStoredCountedAndFound()
    {
        const LibraryFolder folder;
        auto library = folder.open();
        valueOf(library->addInspection(inspectionOf(10000)));     // conforms
        valueOf(library->addInspection(inspectionOf(10200)));     // does not
        valueOf(library->addInspection(inspectionOf(10095)));     // too near
        valueOf(library->addInspection(inspectionOf(10000, -1))); // not decidable
        valueOf(library->addInspection(anInspection()));          // no limits
        NewInspection other = inspectionOf(10200);
        other.expectedType = u"B"_s;
        valueOf(library->addInspection(other)); // another type is wrong whatever its k
        library.reset();
        library = folder.open();
        const InspectionCounts counts = valueOf(library->inspectionCounts());
        QCOMPARE(counts.total, 6);
        QCOMPARE(counts.asExpected, 2);
        QCOMPARE(counts.doesNotConform, 1);
        QCOMPARE(counts.inconclusive, 2);
        QCOMPARE(counts.otherType, 1);
        QCOMPARE(counts.judged(), 4);
        QCOMPARE(counts.expected.value(u"A"_s).asExpected(), 2);
        const HistoryCounts history = valueOf(library->historyCounts({}));
        QCOMPARE(history.doesNotConform, 1);
        QCOMPARE(history.inconclusive, 2);
        QVERIFY(yieldOf(history) == yieldOf(counts));
        // Counted from the rows themselves, not from tallies.
        const HistoryCounts byRows = valueOf(library->historyCounts({.operatorName = u"Ada"_s}));
        QVERIFY(byRows == history);
        const auto keys = [&](InspectionOutcome outcome) {
            return valueOf(library->historyKeys({.outcome = outcome})).size();
        };
        QCOMPARE(keys(InspectionOutcome::DoesNotConform), std::size_t(1));
        QCOMPARE(keys(InspectionOutcome::Inconclusive), std::size_t(2));
        QCOMPARE(keys(InspectionOutcome::AsExpected), std::size_t(2));
        QCOMPARE(keys(InspectionOutcome::OtherType), std::size_t(1));
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void theHistoryTellsIt()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const NewInspection inspection = inspectionOf(10200);
        const InspectionRecord record = valueOf(library->addInspection(inspection));
        QVERIFY(record.conformity == ConformityDecision::DoesNotConform);
        QVERIFY(record.reason.english().contains(u"k 10.2 kN/m is above 10.1 kN/m"_s));
        const HistoryKeys keys = valueOf(library->historyKeys({.order = HistoryColumn::Conformity}));
        const HistoryEntry entry = valueOf(library->historyEntries(keys.part(0, 1))).at(0);
        QVERIFY(entry.conformityValues == inspection.verdict.conformity);
        QVERIFY(entry.outcome() == InspectionOutcome::DoesNotConform);
        QCOMPARE(entry.outcomeName(), u"does_not_conform"_s);
        QCOMPARE(factsOf(HistoryColumn::Conformity).value(entry).toInt(),
                 int(ConformityDecision::DoesNotConform));
        for (const HistoryField& field : historyFields())
            if (QByteArray(field.json) == "conformity") {
                QCOMPARE(field.cells(entry).at(0), u"does_not_conform"_s);
                QCOMPARE(field.value(entry)[u"quantities"_s][u"k"_s][u"value"_s].toDouble(), 10200.0);
            }
        QVERIFY(valueOf(library->historyPoints(HistoryQuery{})).points.at(0).outcome ==
                InspectionOutcome::DoesNotConform);
    }
    void talliesKeepDecisionsApart()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(inspectionOf(10200)));
        valueOf(library->addInspection(inspectionOf(10000)));
        RawDatabase raw(folder.file());
        QCOMPARE(raw.column(u"SELECT verdict FROM inspection_tallies"_s).front(), u"type does_not_conform"_s);
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
        QCOMPARE(valueOf(library->inspectionCounts()).doesNotConform, 1);
    }
    void whatWaitsToBeStoredKeepsIt()
    {
        NewInspection inspection = inspectionOf(10095);
        inspection.id = u"one"_s;
        qint64 memory = mostOfOneFile;
        const NewInspection back = valueOf(unpackInspection(valueOf(packInspection(inspection)), memory));
        QVERIFY(back.verdict.conformity == inspection.verdict.conformity);
    }
    void everyEarlierSchemaGetsThem_data()
    {
        QTest::addColumn<int>("version");
        // Earlier ones come from SQL, see LibraryOpenTest.
        for (int version = 12; version < migrations().back().version; ++version)
            QTest::addRow("version %d", version) << version;
    }
    void everyEarlierSchemaGetsThem()
    {
        QFETCH(int, version);
        const LibraryFolder folder;
        const std::vector<Migration> before = migrationsUpTo(version);
        valueOf(migrate(*valueOf(Database::open(folder.file())), before));
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        QVERIFY(type.limits.isEmpty());
        valueOf(library->setTypeLimits(type.id, stiffnessBetween(1, 2), limitsBecause));
        valueOf(library->addInspection(inspectionOf(10200)));
        QCOMPARE(valueOf(library->inspectionCounts()).doesNotConform, 1);
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
};

GRIPSCOPE_TEST(LibraryLimitsTest)
#include "library_limits_test.moc"
