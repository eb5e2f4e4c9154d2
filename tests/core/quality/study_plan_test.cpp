// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/plan/plan_json.h"
#include "core/quality/plan/plan_words.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QJsonArray>
#include <QTest>

#include <algorithm>
#include <map>
#include <set>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

PlanDesign usualGaugeDesign()
{
    PlanDesign design;
    design.parts = numberedParts(10);
    design.operators = QStringList{u"Ada"_s, u"Bo"_s, u"Cy"_s};
    design.seed = 7;
    return design;
}

/// The design of a study of each kind, which is sound.
PlanDesign soundDesign(StudyKind kind)
{
    PlanDesign design = usualGaugeDesign();
    design.kind = kind;
    if (kind == StudyKind::TypeOne) {
        design.parts = numberedParts(1);
        design.operators.clear();
        design.references = QStringList{u"9990"_s};
        design.trials = 50;
    } else if (kind == StudyKind::Linearity) {
        design.references = numberedParts(10);
    } else if (kind == StudyKind::Attributes) {
        design.references = QStringList(10, u"good"_s);
    }
    return design;
}

/// How often each part, operator and trial is there.
bool isCrossed(const StudyPlan& plan)
{
    std::map<std::tuple<int, int, int, int>, int> seen;
    for (const PlanRow& row : plan.rows)
        ++seen[{row.part, row.operators, row.station, row.trial}];
    const PlanDesign& design = plan.design;
    const auto wanted = std::size_t(design.parts.size()) * std::size_t(design.trials) *
                        std::max<std::size_t>(1, std::size_t(design.operators.size())) *
                        std::max<std::size_t>(1, std::size_t(design.stations.size()));
    return seen.size() == wanted && plan.rows.size() == wanted;
}

} // namespace

class StudyPlanTest : public QObject {
    Q_OBJECT
private slots:
    void everyPartComesOnceBeforeTheNextTrial_data()
    {
        QTest::addColumn<QString>("order");
        for (const auto& order : {u"operators"_s, u"trials"_s, u"mixed"_s})
            QTest::addRow("%s", qPrintable(order)) << order;
    }
    void everyPartComesOnceBeforeTheNextTrial()
    {
        QFETCH(QString, order);
        PlanDesign design = usualGaugeDesign();
        design.order = planOrderFromString(order).value();
        design.stations = QStringList{u"left"_s, u"right"_s};
        const StudyPlan plan = makePlan(design).value();
        QVERIFY(isCrossed(plan));
        std::map<std::pair<int, int>, std::vector<int>> trials; // of an operator at a station, in order
        for (const PlanRow& row : plan.rows)
            trials[{row.operators, row.station}].push_back(row.trial);
        for (const auto& [who, made] : trials)
            QVERIFY(std::ranges::is_sorted(made));
    }
    void operatorAfterOperatorAsInPractice()
    {
        const StudyPlan plan = makePlan(usualGaugeDesign()).value();
        QVERIFY(std::ranges::is_sorted(plan.rows, {}, &PlanRow::operators));
        QCOMPARE(plan.operatorName(0), u"Ada"_s);
        QCOMPARE(plan.operatorName(89), u"Cy"_s);
    }
    void eachTrialHasAnOrderOfItsOwn()
    {
        const StudyPlan plan = makePlan(usualGaugeDesign()).value();
        std::set<std::vector<int>> orders;
        for (std::size_t block = 0; block < 9; ++block) {
            std::vector<int> parts;
            for (std::size_t i = 0; i < 10; ++i)
                parts.push_back(plan.rows[10 * block + i].part);
            orders.insert(parts);
        }
        QCOMPARE(orders.size(), std::size_t(9)); // of 3,628,800
    }
    void ordersAreFair()
    {
        // First places of 3 parts over 3000 seeds: 1000 each, +-5 deviations of sqrt(3000 2/9) = 26.
        PlanDesign design = usualGaugeDesign();
        design.parts = numberedParts(3);
        std::array<int, 3> first{};
        for (design.seed = 0; design.seed < 3000; ++design.seed)
            ++first[std::size_t(makePlan(design)->rows[0].part)];
        for (const int count : first)
            QVERIFY2(std::abs(count - 1000) < 130, qPrintable(QString::number(count)));
    }
    void theSeedDecides()
    {
        PlanDesign other = usualGaugeDesign();
        QCOMPARE(makePlan(other).value(), makePlan(usualGaugeDesign()).value());
        other.seed = 8;
        QVERIFY(makePlan(other)->rows != makePlan(usualGaugeDesign())->rows);
    }
    void everyKindHasItsPlanAndIsStoredAsItIs_data()
    {
        QTest::addColumn<QString>("kind");
        for (const auto& kind : {u"gauge"_s, u"type1"_s, u"linearity"_s, u"attributes"_s})
            QTest::addRow("%s", qPrintable(kind)) << kind;
    }
    void everyKindHasItsPlanAndIsStoredAsItIs()
    {
        QFETCH(QString, kind);
        PlanDesign design = soundDesign(studyKindFromString(kind).value());
        design.seed = 0xFFFF'FFFF'FFFF'FFFFULL; // more than a number of JSON holds
        design.blind = false;
        const auto plan = makePlan(design);
        QVERIFY2(plan, qPrintable(test::whyNot(plan)));
        QVERIFY(isCrossed(*plan));
        QCOMPARE(planFromJson(planJson(*plan)).value(), *plan);
        QCOMPARE(toString(plan->design.kind), kind);
    }
    void whatIsNoPlanIsRefused()
    {
        QJsonObject json = planJson(makePlan(usualGaugeDesign()).value());
        for (const auto& key : {u"kind"_s, u"seed"_s, u"parts"_s, u"rows"_s, u"trials"_s}) {
            QJsonObject broken = json;
            broken.remove(key);
            QVERIFY2(!planFromJson(broken), qPrintable(key));
        }
        QJsonArray rows = json[u"rows"].toArray();
        rows[3] = QJsonArray{10, 0, 0, 0}; // there are ten parts, from 0 on
        json[u"rows"] = rows;
        QVERIFY(!planFromJson(json));
    }
    void whatIsNoStudyIsRefused()
    {
        const auto refused = [](const std::function<void(PlanDesign&)>& change, StudyKind kind) {
            PlanDesign design = soundDesign(kind);
            change(design);
            return !makePlan(design) && makePlan(design).error().code == ErrorCode::Usage;
        };
        using Design = PlanDesign&;
        QVERIFY(refused([](Design d) { d.parts = numberedParts(1); }, StudyKind::Gauge));
        QVERIFY(refused([](Design d) { d.trials = 0; }, StudyKind::Gauge));
        QVERIFY(refused([](Design d) { d.trials = 1'000'000'000; }, StudyKind::Gauge));
        QVERIFY(refused([](Design d) { d.operators << d.operators[0]; }, StudyKind::Gauge));
        QVERIFY(refused([](Design d) { d.parts[3] = u" "_s; }, StudyKind::Gauge));
        QVERIFY(refused([](Design d) { d.parts = numberedParts(2); }, StudyKind::TypeOne));
        QVERIFY(refused([](Design d) { d.references.clear(); }, StudyKind::TypeOne));
        QVERIFY(refused([](Design d) { d.references[2] = u"stiff"_s; }, StudyKind::Linearity));
        QVERIFY(refused([](Design d) { d.references.removeLast(); }, StudyKind::Attributes));
    }
    void aStudyGoesOnWhereItStopped()
    {
        const StudyPlan plan = makePlan(usualGaugeDesign()).value();
        QCOMPARE(*progressOf(plan, {}).next, std::size_t(0));
        std::vector<StudyAttempt> attempts{{0, AttemptOutcome::Measured}, {1, AttemptOutcome::Invalid},
                                           {1, AttemptOutcome::Measured}, {2, AttemptOutcome::Skipped},
                                           {3, AttemptOutcome::Invalid},  {900, AttemptOutcome::Measured}};
        const StudyProgress progress = progressOf(plan, attempts);
        QCOMPARE(progress.done, std::size_t(2));
        QCOMPARE(progress.skipped, std::size_t(1));
        QCOMPARE(progress.repeated, std::size_t(1));
        QCOMPARE(progress.left(), std::size_t(87));
        QCOMPARE(*progress.next, std::size_t(3));
        QVERIFY(progress.rows[3] == RowState::Repeat && progress.rows[4] == RowState::Planned);
        QCOMPARE(*progress.counts[1], std::size_t(2));
        QCOMPARE(*progress.undoable, std::size_t(3)); // the skip: what was in vain is passed over
        attempts[3].undone = true;
        QCOMPARE(*progressOf(plan, attempts).next, std::size_t(2));       // at once
        QVERIFY(progressOf(plan, attempts).rows[2] == RowState::Planned); // it was never squeezed
        attempts[2].undone = true;
        QVERIFY(progressOf(plan, attempts).rows[1] == RowState::Repeat);
        QCOMPARE(*progressOf(plan, attempts).undoable, std::size_t(0));
    }
    void aPersonIsToldTheLabelAlone()
    {
        PlanDesign design = usualGaugeDesign();
        design.stations = QStringList{u"left"_s};
        const StudyPlan plan = makePlan(design).value();
        QCOMPARE(instruction(plan, 31).describe(),
                 u"Bo puts in part %1 (trial 1 of 3). At station left."_s.arg(plan.part(31)));
        QCOMPARE(progressWords(progressOf(plan, {{0, AttemptOutcome::Skipped}})).describe(),
                 u"Squeeze 2 of 90. Left out: 1."_s);
        const StudyPlan alone = makePlan(soundDesign(StudyKind::TypeOne)).value();
        QCOMPARE(instruction(alone, 4).describe(), u"Put in part 1 (trial 5 of 50)."_s);
    }
};
GRIPSCOPE_TEST(StudyPlanTest)
#include "study_plan_test.moc"
