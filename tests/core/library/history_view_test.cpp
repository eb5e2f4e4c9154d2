// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_facts.h"
#include "core/library/records/batch.h"
#include "core/library/records/history.h"
#include "core/session/library/history_document.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/many_inspections.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

std::vector<HistoryEntry> entriesOf(const Library& library, const HistoryQuery& query, std::size_t first = 0,
                                    std::size_t count = 200)
{
    return valueOf(library.historyEntries(valueOf(library.historyKeys(query)).part(first, count)));
}

std::vector<qint64> numbersOf(const Library& library, const HistoryQuery& query, std::size_t first = 0,
                              std::size_t count = 200)
{
    std::vector<qint64> numbers;
    for (const HistoryEntry& entry : entriesOf(library, query, first, count))
        numbers.push_back(entry.number);
    return numbers;
}

using Numbers = std::vector<qint64>;

} // namespace

class HistoryViewTest : public QObject {
    Q_OBJECT
private slots:
    void anInspectionAndAnEnrolmentComeBackAsTheyWereStored()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString type = valueOf(library->addType(u"Can"_s, {}, u"N"_s, u"m"_s)).id;
        NewGrasp grasp = aGrasp(type);
        grasp.part = u"7"_s;
        const GraspRecord enrolled = valueOf(library->addGrasp(grasp));
        NewInspection inspection = anInspection();
        inspection.grasp.recording->provenance[u"device"_s] = u"Gripper"_s;
        inspection.grasp.recording->provenance[u"serial"_s] = u"0001"_s;
        inspection.grasp.recording->provenance[u"firmware"_s] = u"1.2"_s;
        const InspectionRecord inspected = valueOf(library->addInspection(inspection));

        const auto found = entriesOf(*library, {});
        QCOMPARE(found.size(), std::size_t(2));
        const HistoryEntry& first = found[0];
        QCOMPARE(first.graspId, inspected.graspId);
        QVERIFY(first.kind == SqueezeKind::Inspection && first.outcome() == InspectionOutcome::AsExpected);
        QCOMPARE(first.number, 1);
        QCOMPARE(first.reason.describe(), u"First. Second."_s);
        QCOMPARE(*first.posterior, 0.75);
        QVERIFY(*first.parameters == *inspection.grasp.estimates[0].parameters);
        QCOMPARE((*first.standardErrors)(0), 1e-4);
        QCOMPARE(first.device + u'/' + first.serial + u'/' + first.firmware, u"Gripper/0001/1.2"_s);
        QCOMPARE(*first.heldTo.falseReject, inspection.rates.falseReject);
        QCOMPARE(first.estimator, u"oe"_s);
        QCOMPARE(first.program, QStringLiteral(GRIPSCOPE_VERSION));
        const HistoryEntry& second = found[1];
        QCOMPARE(second.graspId, enrolled.id);
        QVERIFY(second.kind == SqueezeKind::Enrollment && !second.outcome() && second.number == 0);
        QCOMPARE(second.type, u"Can"_s);
        QCOMPARE(second.part, u"7"_s);
        QVERIFY(second.accepted);
        valueOf(library->dropGrasp(enrolled.id, u"slipped"_s, u"Ada"_s));
        valueOf(library->renameType(type, u"Tin"_s, {u"Ada"_s, u"a better name"_s}));
        QVERIFY(!entriesOf(*library, {})[1].accepted);
        QCOMPARE(entriesOf(*library, {})[1].type, u"Tin"_s);
    }
    void everyFilterLetsThroughWhatItSays_data()
    {
        QTest::addColumn<HistoryQuery>("query");
        QTest::addColumn<int>("count");
        QTest::addColumn<Numbers>("first");
        const auto row = [](const char* name, HistoryQuery query, int count, Numbers first) {
            QTest::newRow(name) << query << count << first;
        };
        const QDateTime start(QDate(2024, 1, 1), QTime(0, 0), Qt::UTC);
        row("everything", {}, 40, {40, 39, 38});
        row("text in the operator, any case", {.text = u"bob"_s}, 20, {39, 37, 35});
        row("text in the source", {.text = u"FILE 7"_s}, 1, {7});
        row("text in the number", {.text = u"23"_s}, 1, {23});
        row("text in the gripper", {.text = u"gripper 0002"_s}, 13, {38, 35, 32});
        row("signs of the search language", {.text = u"_"_s}, 0, {});
        row("inspections", {.kind = SqueezeKind::Inspection}, 40, {40, 39, 38});
        row("enrolments", {.kind = SqueezeKind::Enrollment}, 0, {});
        row("as expected", {.outcome = InspectionOutcome::AsExpected}, 31, {39, 38, 37});
        row("other type", {.outcome = InspectionOutcome::OtherType}, 5, {35, 28, 21});
        row("unknown", {.outcome = InspectionOutcome::Unknown}, 4, {40, 30, 20});
        row("not valid", {.outcome = InspectionOutcome::NotValid}, 0, {});
        row("valid", {.validity = ValidityVerdict::Valid}, 40, {40, 39, 38});
        row("suspect", {.validity = ValidityVerdict::Suspect}, 0, {});
        row("type", {.type = u"B"_s}, 5, {35, 28, 21});
        row("expected", {.expected = u"A"_s}, 40, {40, 39, 38});
        row("operator", {.operatorName = u"Ada"_s}, 20, {40, 38, 36});
        row("gripper", {.device = u"Gripper 0000"_s}, 13, {39, 36, 33});
        row("from on", {.from = start.addSecs(38 * 60)}, 3, {40, 39, 38});
        row("before", {.to = start.addSecs(3 * 60)}, 2, {2, 1});
        row("two at once", {.outcome = InspectionOutcome::Unknown, .operatorName = u"Bob"_s}, 0, {});
    }
    void everyFilterLetsThroughWhatItSays()
    {
        QFETCH(HistoryQuery, query);
        QFETCH(int, count);
        QFETCH(Numbers, first);
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 40);
        QCOMPARE(valueOf(library->historyKeys(query)).size(), std::size_t(count));
        QCOMPARE(numbersOf(*library, query, 0, 3), first);
        QCOMPARE(valueOf(library->historyCounts(query)).total(), count);
        QCOMPARE(valueOf(library->historyPoints(query)).points.size(), std::size_t(count));
        QCOMPARE(query.everything(),
                 count == 40 && !query.kind && !query.validity && query.expected.isEmpty());
    }
    void everyOrderGoesBothWays_data()
    {
        QTest::addColumn<int>("order");
        QTest::addColumn<Numbers>("up");
        QTest::addColumn<Numbers>("down");
        const auto row = [](const char* name, HistoryColumn order, Numbers up, Numbers down) {
            QTest::newRow(name) << int(order) << up << down;
        };
        // Of equal ones the newest comes first.
        row("time", HistoryColumn::Time, {1, 2, 3}, {40, 39, 38});
        row("number", HistoryColumn::Number, {1, 2, 3}, {40, 39, 38});
        row("kind", HistoryColumn::Kind, {40, 39, 38}, {40, 39, 38});
        row("expected", HistoryColumn::Expected, {40, 39, 38}, {40, 39, 38});
        row("outcome", HistoryColumn::Outcome, {39, 38, 37}, {40, 30, 20});
        row("type", HistoryColumn::Type, {39, 38, 37}, {35, 28, 21});
        row("posterior", HistoryColumn::Posterior, {39, 38, 37}, {1, 2, 3});
        row("mass", HistoryColumn::Mass, {1, 2, 3}, {40, 39, 38});
        row("damping", HistoryColumn::Damping, {40, 39, 38}, {40, 39, 38});
        row("stiffness", HistoryColumn::Stiffness, {1, 2, 3}, {40, 39, 38});
        row("fit", HistoryColumn::Fit, {40, 39, 38}, {40, 39, 38});
        row("seconds", HistoryColumn::Seconds, {40, 39, 38}, {40, 39, 38});
        row("operator", HistoryColumn::Operator, {40, 38, 36}, {39, 37, 35});
        row("device", HistoryColumn::Device, {39, 36, 33}, {38, 35, 32});
        row("estimator", HistoryColumn::Estimator, {40, 39, 38}, {40, 39, 38});
        row("program", HistoryColumn::Program, {40, 39, 38}, {40, 39, 38});
        row("validity", HistoryColumn::Validity, {40, 39, 38}, {40, 39, 38});
        row("library version", HistoryColumn::LibraryVersion, {40, 39, 38}, {40, 39, 38});
    }
    void everyOrderGoesBothWays()
    {
        QFETCH(int, order);
        QFETCH(Numbers, up);
        QFETCH(Numbers, down);
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 40);
        HistoryQuery query;
        query.order = HistoryColumn(order);
        QCOMPARE(numbersOf(*library, query, 0, 3), down);
        query.descending = false;
        QCOMPARE(numbersOf(*library, query, 0, 3), up);
    }
    void whatWasInForceStaysWithTheSqueeze()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewInspection inspection = anInspection();
        inspection.rates.strangerAccept = 0.02;
        inspection.rates.confidence = 0.95;
        inspection.rates.robust = true;
        inspection.libraryVersion = 7;
        const CalibrationRecord calibration{aCalibration(), u"k-1"_s, {}, {}};
        const SensorCorrection correction(valueOf(evaluateCalibration(calibration)).curve);
        inspection.grasp.recording->provenance[u"serial"_s] = u"0001"_s;
        noteCalibration(inspection.grasp.recording->provenance, calibration, correction, QDate(2026, 4, 1));
        valueOf(library->addInspection(inspection));
        NewInspection none = anInspection(); // of no gripper, on average
        none.grasp.recording->provenance.clear();
        valueOf(library->addInspection(none));

        const auto found = entriesOf(*library, {});
        const HistoryEntry& first = found.at(1);
        QVERIFY(first.heldTo == (HeldTo{0.01, 0.001, 0.02, 0.95, true}));
        QCOMPARE(first.libraryVersion, std::optional<qint64>(7));
        QCOMPARE(*first.forceCalibration, u"taken 2026-03-01 against Weights M1, holds until 2027-03-01"_s);
        QCOMPARE(first.forceCalibrationId, u"k-1"_s);
        QCOMPARE(first.positionCalibration, std::optional<QString>(u""_s)); // none was in force
        QVERIFY(!found.at(0).forceCalibration && !found.at(0).libraryVersion);
        QVERIFY(found.at(0).heldTo == (HeldTo{0.01, 0.001, 0.01, {}, false}));

        // Another calibration today changes nothing of what was.
        SensorCalibration today = aCalibration();
        today.reference.name = u"Load cell 7"_s;
        valueOf(library->addCalibration(today));
        const HistoryInForce then = valueOf(library->historyInForce({}));
        QCOMPARE(then.rates.size(), std::size_t(2));
        QCOMPARE(then.calibrations.at(u"0001"_s).force.at(first.forceCalibration), 1);
        QCOMPARE(then.calibrations.at(u"0001"_s).position.at(u""_s), 1);
        QVERIFY(then.calibrations.at({}).force.begin()->first == std::nullopt);
        QVERIFY(then.firstVersion == 7 && then.lastVersion == 7);
        QCOMPARE(then.withoutVersion, 1);
        QCOMPARE(then.programs.at(QStringLiteral(GRIPSCOPE_VERSION)), 2);
        const QJsonObject json = toJson(first);
        QCOMPARE(json[u"stranger_accept_rate"_s].toDouble(), 0.02);
        QCOMPARE(json[u"confidence"_s].toDouble(), 0.95);
        QCOMPARE(json[u"robust"_s].toBool(), true);
        QCOMPARE(json[u"library_version"_s].toInt(), 7);
        QCOMPARE(json[u"position_calibration"_s].toString(), u"none"_s);
        QVERIFY(toJson(found.at(0))[u"force_calibration"_s].isNull());
    }
    void validityTravelsWithTheSqueeze()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto add = [&](VerdictKind kind, ValidityVerdict validity, const QStringList& failed) {
            NewInspection inspection = anInspection(kind);
            inspection.verdict.validity.verdict = validity;
            inspection.verdict.validity.checksFailed = failed;
            if (validity == ValidityVerdict::Suspect)
                inspection.verdict.validity.reasons = {u"Overdue."_s};
            valueOf(library->addInspection(inspection));
        };
        add(VerdictKind::Type, ValidityVerdict::Valid, {});
        add(VerdictKind::Type, ValidityVerdict::Suspect, {u"samples_lost"_s, u"calibration"_s});
        add(VerdictKind::Invalid, ValidityVerdict::Invalid, {u"saturation"_s});
        add(VerdictKind::Unknown, ValidityVerdict::Suspect, {u"calibration"_s});
        const auto numbers = [&](ValidityVerdict validity) {
            return numbersOf(*library, {.validity = validity});
        };
        QCOMPARE(numbers(ValidityVerdict::Valid), Numbers({1}));
        QCOMPARE(numbers(ValidityVerdict::Suspect), Numbers({4, 2}));
        QCOMPARE(numbers(ValidityVerdict::Invalid), Numbers({3}));
        QCOMPARE(numbersOf(*library, {.order = HistoryColumn::Validity, .descending = false}),
                 Numbers({1, 4, 2, 3}));
        const HistoryCounts counts = valueOf(library->historyCounts({}));
        QCOMPARE(counts.suspect, 2);
        QCOMPARE(counts.notValid, 1);
        const HistoryEntry second = entriesOf(*library, {}).at(2);
        QVERIFY(second.suspect());
        QCOMPARE(second.checksFailed, QStringList({u"samples_lost"_s, u"calibration"_s}));
        QVERIFY2(second.reason.describe().endsWith(u"Overdue."_s), qPrintable(second.reason.describe()));
        QCOMPARE(toJson(second)[u"validity"_s].toString(), u"suspect"_s);
        QCOMPARE(toJson(second)[u"checks_failed"_s].toArray().size(), 2);
        QVERIFY(toCsv({second}).contains(",suspect,samples_lost calibration,"));
        const HistoryPoints points = valueOf(library->historyPoints(HistoryQuery{}));
        QVERIFY(points.points.at(1).validity == ValidityVerdict::Suspect);
        QVERIFY(points.points.at(2).validity == ValidityVerdict::Invalid);
    }
    void ofBeforeTheDocumentTellsTheValidity()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addInspection(anInspection()));
        RawDatabase raw(folder.file());
        raw.run(u"UPDATE inspections SET validity = ''"_s);
        QVERIFY(!entriesOf(*library, {}).at(0).validity); // it does not say either
        raw.run(u"UPDATE documents SET packed = NULL, document = "
                "'{\"validity\":{\"checks\":[],\"verdict\":\"suspect\"}}'"_s);
        QVERIFY(entriesOf(*library, {}).at(0).suspect());
        QCOMPARE(numbersOf(*library, {.validity = ValidityVerdict::Suspect}), Numbers({1}));
        QCOMPARE(valueOf(library->historyCounts({})).suspect, 1);
    }
    void theYieldIsOneEverywhere()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        for (const VerdictKind kind : {VerdictKind::Type, VerdictKind::Type, VerdictKind::Type,
                                       VerdictKind::Unknown, VerdictKind::Inconclusive, VerdictKind::Invalid})
            valueOf(library->addInspection(anInspection(kind)));
        const Yield history = yieldOf(valueOf(library->historyCounts({})));
        QVERIFY(history == yieldOf(valueOf(library->inspectionCounts())));
        QVERIFY(history == (Yield{3, 4})); // what judged nothing is left out
        QVERIFY(!Yield{}.share());
    }
    void theFilterOfAnExportNamesItsBatch()
    {
        HistoryQuery query;
        query.batch = u"4711"_s;
        query.validity = ValidityVerdict::Suspect;
        const QJsonObject filter = toJson(query);
        QCOMPARE(filter[u"batch"_s].toString(), u"4711"_s);
        QCOMPARE(filter[u"validity"_s].toString(), u"suspect"_s);
        QVERIFY(toJson(HistoryQuery()).isEmpty());
    }
    void massesOfUnlikeUnitsAreOrderedInSi()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto add = [&](const QString& force, const QString& position, double m) {
            NewInspection inspection = anInspection();
            inspection.grasp.forceUnit = force;
            inspection.grasp.positionUnit = position;
            inspection.grasp.estimates = {anEstimate(m)};
            valueOf(library->addInspection(inspection));
        };
        add(u"N"_s, u"m"_s, 0.03);
        add(u"N"_s, u"mm"_s, 2e-5); // 20 g
        add(u"kN"_s, u"m"_s, 4e-5); // 40 g
        NewInspection none = anInspection(VerdictKind::Invalid);
        none.grasp.estimates.clear();
        valueOf(library->addInspection(none));
        HistoryQuery query;
        query.order = HistoryColumn::Mass;
        QCOMPARE(numbersOf(*library, query), Numbers({3, 1, 2, 4}));
        query.descending = false;
        QCOMPARE(numbersOf(*library, query), Numbers({2, 1, 3, 4})); // without a mass still last
        const HistoryPoints points = valueOf(library->historyPoints(HistoryQuery{}));
        QVERIFY(points.si);
        QCOMPARE(points.points.size(), std::size_t(3));
        QVERIFY(qFuzzyCompare(points.points[1].parameters.m, 0.02));
        QVERIFY(qFuzzyCompare(points.points[1].standardErrors.m, 0.1)); // 1e-4 of those units
    }
    void aTypesPlaceInChartsIsItsForLife()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString first = valueOf(library->addType(u"Zinc"_s, {}, u"N"_s, u"m"_s)).id;
        const QString second = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
        for (const QString& type : {first, second})
            for (int i = 0; i < 2; ++i)
                valueOf(library->addGrasp(aGrasp(type, 9990 + i)));
        valueOf(library->approveType(second, u"Ada"_s));
        valueOf(library->addInspection(anInspection()));
        valueOf(library->addInspection(anInspection(VerdictKind::Type, u"Elsewhere"_s)));
        const auto placeOf = [&](const QString& type) {
            const HistoryPoints points = valueOf(library->historyPoints(HistoryQuery{}));
            return points.places.at(std::size_t(points.types.indexOf(type)));
        };
        QCOMPARE(placeOf(u"A"_s), 1);
        QCOMPARE(placeOf(u"Zinc"_s), 0);
        QCOMPARE(placeOf(u"Elsewhere"_s), 2); // no type ever was called so
        // Waiting for approval again, renamed, retired: the same type still.
        valueOf(library->addGrasp(aGrasp(second, 9992)));
        QCOMPARE(placeOf(u"A"_s), 1);
        valueOf(library->renameType(second, u"Tin"_s, {u"Ada"_s, u"a better name"_s}));
        QCOMPARE(placeOf(u"Tin"_s), 1);
        QCOMPARE(placeOf(u"A"_s), 1); // of the inspection, which keeps the old name
        valueOf(library->retireType(first, {u"Ada"_s, u"no longer made"_s}));
        QCOMPARE(placeOf(u"Zinc"_s), 0);
        // Whoever has a name now has it before one that had it once.
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        QCOMPARE(placeOf(u"A"_s), 2);
    }
    void aBatchIsFoundByItsName()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto inspect = [&](const QString& batchId) {
            NewInspection inspection = anInspection();
            inspection.batchId = batchId;
            valueOf(library->addInspection(inspection));
        };
        const auto begin = [&](const QString& name) {
            const QString id = valueOf(library->beginBatch({name, 2, {}, u"Ada"_s})).id;
            inspect(id);
            inspect(id);
            valueOf(library->endBatch(id, u"Ada"_s));
        };
        begin(u"4712"_s);
        begin(u"4711"_s);
        inspect({});
        HistoryQuery query;
        query.batch = u"4712"_s;
        QCOMPARE(numbersOf(*library, query), Numbers({2, 1}));
        QCOMPARE(valueOf(library->historyCounts(query)).asExpected, 2);
        QCOMPARE(entriesOf(*library, query)[0].batch, u"4712"_s);
        QCOMPARE(numbersOf(*library, {.text = u"4711"_s}), Numbers({4, 3}));
        QCOMPARE(numbersOf(*library, {.order = HistoryColumn::Batch, .descending = false}),
                 Numbers({4, 3, 2, 1, 5})); // of none last
        QCOMPARE(valueOf(library->historyChoices()).batches, QStringList({u"4711"_s, u"4712"_s}));
    }
    void anyPageOfAHundredThousandIsReadAtOnce()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        addManyInspections(folder.file(), 100'000);
        QCOMPARE(numbersOf(*library, {}, 99'998), Numbers({2, 1}));
        HistoryQuery query;
        query.outcome = InspectionOutcome::Unknown;
        query.order = HistoryColumn::Stiffness;
        QCOMPARE(numbersOf(*library, query, 5'000, 2), Numbers({50'000, 49'990}));
        query.outcome.reset();
        query.text = u"FILE 99990"_s;
        QCOMPARE(numbersOf(*library, query), Numbers({99'990}));
        const HistoryCounts counts = valueOf(library->historyCounts({}));
        QCOMPARE(counts.total(), 100'000);
        QCOMPARE(counts.unknown, 10'000);
        const HistoryChoices choices = valueOf(library->historyChoices());
        QCOMPARE(choices.operators, QStringList({u"Ada"_s, u"Bob"_s}));
        QCOMPARE(choices.types, QStringList({u"A"_s, u"B"_s}));
        QCOMPARE(choices.devices.size(), 3);
    }
    void aLaterEstimateStandsBesideTheFirst()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const InspectionRecord inspection = valueOf(library->addInspection(anInspection()));
        Estimate other = anEstimate(0.05, 50, 8000);
        other.estimator = Estimator::InstrumentalVariables;
        Reidentification how;
        how.hold = ForceHold::Zero;
        how.initialState = InitialState::Rest;
        how.freeOffset = false;
        how.operatorName = u"Zoë"_s;
        valueOf(library->addReidentification(inspection.graspId, other, how));
        const SqueezeDetails details = valueOf(library->squeezeDetails(inspection.graspId));
        QCOMPARE(details.estimates.size(), std::size_t(3));
        const StoredEstimate& later = details.estimates[2];
        QCOMPARE(later.rank, 2);
        QCOMPARE(later.estimator, u"iv"_s);
        QCOMPARE(later.program, QStringLiteral(GRIPSCOPE_VERSION));
        QVERIFY(later.again && later.again->hold == ForceHold::Zero && !later.again->freeOffset);
        QVERIFY(later.again->initialState == InitialState::Rest);
        QCOMPARE(later.again->operatorName, u"Zoë"_s);
        QVERIFY(!details.estimates[0].again);
        QCOMPARE(details.samples, std::size_t(500));
        QCOMPARE(details.provenance.value(u"device"_s), u"virtual:"_s);
        QCOMPARE(details.document.value(u"recommended"_s).toString(), u"oe"_s);
        // The verdict and the estimate that stands for the squeeze are what they were.
        QVERIFY(*details.entry.parameters == *anEstimate().parameters);
        QVERIFY(details.entry.outcome() == InspectionOutcome::AsExpected);
    }
    void aLaterEstimateNeverBecomesTheFirst()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewInspection inspection = anInspection(VerdictKind::Invalid);
        inspection.grasp.estimates.clear();
        const QString grasp = valueOf(library->addInspection(inspection)).graspId;
        valueOf(library->addReidentification(grasp, anEstimate(), {}));
        const SqueezeDetails details = valueOf(library->squeezeDetails(grasp));
        QVERIFY(!details.entry.parameters);
        QCOMPARE(details.estimates.at(0).rank, 1);
        Estimate broken = anEstimate();
        broken.parameters->m = qQNaN();
        QCOMPARE(library->addReidentification(grasp, broken, {}).error().code, ErrorCode::Usage);
        QCOMPARE(library->addReidentification(u"none"_s, anEstimate(), {}).error().code, ErrorCode::NotFound);
        QCOMPARE(library->squeezeDetails(u"none"_s).error().code, ErrorCode::NotFound);
    }
};

GRIPSCOPE_TEST(HistoryViewTest)
#include "history_view_test.moc"
