// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/batch.h"
#include "core/library/records/history.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/many_inspections.h"
#include "tests/support/test_registry.h"

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
        QCOMPARE(*first.falseReject, inspection.rates.falseReject);
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
        QCOMPARE(query.everything(), count == 40 && !query.kind && query.expected.isEmpty());
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
        const HistoryPoints points = valueOf(library->historyPoints({}));
        QVERIFY(points.si);
        QCOMPARE(points.points.size(), std::size_t(3));
        QVERIFY(qFuzzyCompare(points.points[1].parameters.m, 0.02));
        QVERIFY(qFuzzyCompare(points.points[1].standardErrors.m, 0.1)); // 1e-4 of those units
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
