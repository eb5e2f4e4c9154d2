// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_result.h"
#include "tests/core/session/study_samples.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const QStringList threePeople{u"Ada"_s, u"Bo"_s, u"Cy"_s};

KeptStudy usualStudy(std::array<double, 3> spreads)
{
    return madeStudy(crossedDesign(10, threePeople, 3), spreads);
}

} // namespace

/// What a study says, as values for pages, reports and files.
class KeptStudyTest : public QObject {
    Q_OBJECT
private slots:
    void whatCountsIsOneARow()
    {
        KeptStudy study = usualStudy({0.03, 0.01, 0.005});
        QCOMPARE(study.counted().size(), std::size_t(90));
        study.measurements[4].undone = true;
        study.measurements[5].measured.outcome = u"skipped"_s;
        StudyMeasurementRecord again = study.measurements[4];
        again.undone = false;
        again.id = u"again"_s;
        study.measurements.push_back(again);
        QCOMPARE(study.counted().size(), std::size_t(89));
        QCOMPARE(study.counted().back()->id, u"again"_s);
        QCOMPARE(study.progress().repeated, std::size_t(1));
    }
    void theTableReadsBackAsItIs()
    {
        KeptStudy study = usualStudy({0.03, 0.01, 0.005});
        study.plan.design.parts[0] = u"can \"7\", red"_s;
        const StudyTable direct = studyTable(study);
        const StudyTable file = StudyTable::parse(studyCsv(study), u"study.csv"_s).value();
        QCOMPARE(file.columns(), direct.columns());
        for (const auto& column : {u"m"_s, u"b"_s, u"k"_s, u"u_m"_s, u"u_k"_s, u"row"_s})
            QCOMPARE(file.numbers(column).value(), direct.numbers(column).value()); // to the last bit
        for (const auto& column : {u"part"_s, u"operator"_s, u"unit_k"_s, u"utc"_s})
            QCOMPARE(file.labels(column)->names, direct.labels(column)->names);
        QCOMPARE(file.labels(u"utc"_s)->names[0], u"2026-03-01T07:30:00.000Z"_s);
    }
    void columnsThatThePlanHasNotAreNotThere()
    {
        PlanDesign design = crossedDesign(4, {}, 3);
        QVERIFY(!studyTable(madeStudy(design, {0.03, 0, 0.005})).columns().contains(u"operator"_s));
        design.stations = QStringList{u"left"_s, u"right"_s};
        design.references = numberedParts(4);
        const QStringList columns = studyTable(madeStudy(design, {0.03, 0, 0.005})).columns();
        QVERIFY(columns.contains(u"station"_s) && columns.contains(u"reference"_s));
    }
    void chartsShowWhatWasMeasured()
    {
        KeptStudy study = madeStudy(crossedDesign(2, {u"Ada"_s, u"Bo"_s}, 2), {});
        // k = 100 (part + 1) + 10 operator + trial: means, ranges and the lack of an interaction are plain.
        for (StudyMeasurementRecord& one : study.measurements) {
            const PlanRow& row = study.plan.rows[std::size_t(one.measured.row)];
            one.measured.values = {std::nullopt, std::nullopt,
                                   StudyValue{100.0 * (row.part + 1) + 10 * row.operators + row.trial, 0}};
        }
        const auto result = gaugeResult(study);
        QVERIFY2(result, qPrintable(whyNot(result)));
        QCOMPARE(result->quantities.size(), std::size_t(1)); // the others were not determined
        const QuantitySummary& k = result->quantities[0];
        QCOMPARE(k.name, u"k"_s);
        QCOMPARE(k.unit, u"N/m"_s);
        QCOMPARE(k.mean, 155.5);
        QCOMPARE(k.parts.size(), std::size_t(2));
        QCOMPARE(k.parts[1].mean, 205.5);
        QCOMPARE(k.operators[1].mean, 160.5);
        QCOMPARE(k.operators[1].count, 4);
        QCOMPARE(k.cells.size(), std::size_t(4));
        QCOMPARE(k.cells[3].mean, 210.5);
        QCOMPARE(k.cells[3].range, 1.0);
        QCOMPARE(k.cells[3].deviation, std::sqrt(0.5));
        QCOMPARE(k.meanRange, 1.0);
        QVERIFY(std::abs(*k.rangeUpper - 3.267) < 5e-4); // D4 of two, to the digits of tables
        QCOMPARE(*k.rangeLower, 0.0);
        QVERIFY(!result->study.values[0].consistency); // nothing is known of the squeezes' own errors
    }
    void theVerdictIsPlain()
    {
        const auto good = resultOf(usualStudy({0.03, 0, 0.005}));
        QVERIFY(good);
        QCOMPARE(good->gauge()->study.values.size(), std::size_t(3));
        QVERIFY(good->gauge()->study.joint && good->gauge()->study.values[2].consistency);
        const double kinds = *good->gauge()->study.values[0].distinctCategories; // all three scatter alike
        QCOMPARE(good->verdict.back().describe(), u"Operators are not the trouble."_s);
        QVERIFY(good->verdict.front().describe().startsWith(u"This gripper tells "_s));
        QVERIFY(good->verdict.front().describe().contains(QString::number(std::floor(kinds))));
        const auto people = resultOf(usualStudy({0.03, 0.05, 0.005}));
        QVERIFY(people->verdict.back().describe().startsWith(u"Operators are the trouble: they make 9"_s));
        const auto blunt = resultOf(usualStudy({0.001, 0, 0.03}));
        QVERIFY(blunt->verdict.front().describe().startsWith(u"This gripper does not tell these parts"_s));
    }
    void ownUncertaintiesAreHeldAgainstTheRepeats()
    {
        KeptStudy study = usualStudy({0.03, 0, 0.005});
        const double asStated = gaugeResult(study)->study.values[2].consistency->ratio;
        QVERIFY(asStated > 0.8 && asStated < 1.2); // chi of 60 degrees of freedom: 1 +- 0.09
        for (StudyMeasurementRecord& one : study.measurements)
            one.measured.values[2]->standardUncertainty /= 3;
        const GaugeValue k = gaugeResult(study)->study.values[2];
        QVERIFY(std::abs(k.consistency->ratio - 3 * asStated) < 1e-9);
        QVERIFY(k.consistency->above < 1e-6);
    }
    void tolerancesAndOptionsAreStored()
    {
        StudyOptions options;
        options.tolerances = {std::nullopt, 1.0 / 3, 400.0};
        options.studyVariation = 5.15;
        options.pooling = false;
        options.repeatAfterMonths = 0;
        QCOMPARE(studyOptionsFromJson(toJson(options)), options);
        QCOMPARE(studyOptionsFromJson({}), StudyOptions());
    }
    void whatSaysNothingIsAnError()
    {
        KeptStudy empty = usualStudy({0.03, 0, 0.005});
        empty.measurements.clear();
        QCOMPARE(gaugeResult(empty).error().code, ErrorCode::BadInput);
        KeptStudy mixed = usualStudy({0.03, 0, 0.005});
        mixed.measurements[7].measured.units[2] = u"N/mm"_s;
        QCOMPARE(gaugeResult(mixed).error().code, ErrorCode::BadInput);
    }
    void whatIsLeftOutIsCounted()
    {
        KeptStudy study = usualStudy({0.03, 0, 0.005});
        study.measurements[5].measured.outcome = u"skipped"_s;
        study.measurements.pop_back();
        const auto result = resultOf(study);
        QVERIFY(result);
        QVERIFY(!result->gauge()->study.balanced && result->gauge()->study.rows == 88);
        QCOMPARE(result->left, std::size_t(1));
        QCOMPARE(result->skipped, std::size_t(1));
        QVERIFY(!result->gauge()->quantities[0].rangeUpper); // cells differ in number
    }
};
GRIPSCOPE_TEST(KeptStudyTest)
#include "kept_study_test.moc"
