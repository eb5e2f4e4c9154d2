// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_result.h"
#include "tests/core/session/study_samples.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

KeptStudy referencedStudy(StudyKind kind, const QStringList& references, int trials)
{
    PlanDesign design = crossedDesign(int(references.size()), {}, trials);
    design.kind = kind;
    design.references = references;
    return madeStudy(design, {0, 0, 0.001}); // k of all parts about 9990
}

/// Raters who always agree: odd parts are good.
KeptStudy ratedStudy(const QStringList& raters)
{
    PlanDesign design = crossedDesign(6, raters, 2);
    design.kind = StudyKind::Attributes;
    KeptStudy study = madeStudy(design, {0, 0, 0});
    for (StudyMeasurementRecord& one : study.measurements)
        one.measured.rating =
            study.plan.rows[std::size_t(one.measured.row)].part % 2 == 0 ? u"good"_s : u"bad"_s;
    return study;
}

QString firstSentence(const Expected<StudyResult>& result)
{
    return result ? result->verdict.front().describe() : result.error().describe();
}

} // namespace

class ResultOfEachKindTest : public QObject {
    Q_OBJECT
private slots:
    void aTypeOneStudyIsCapableWithinItsTolerance()
    {
        KeptStudy study = referencedStudy(StudyKind::TypeOne, {u"9990"_s}, 50);
        QVERIFY(resultOf(study).error().code == ErrorCode::Usage); // no tolerance
        study.options.tolerances[2] = 1000;                        // 0.2 T / (6 x 10) is 3.3
        const auto capable = resultOf(study);
        QVERIFY2(firstSentence(capable).startsWith(u"Capable"_s), qPrintable(firstSentence(capable)));
        const TypeOneResult* const found = capable->as<TypeOneResult>();
        QVERIFY(found != nullptr && capable->gauge() == nullptr);
        QCOMPARE(found->study.count, std::size_t(50));
        QCOMPARE(found->options.reference, 9990.0);
        study.options.tolerances[2] = 100; // a tenth of it
        QVERIFY(firstSentence(resultOf(study)).startsWith(u"Not capable"_s));
    }
    void sentencesNameTheUnitOfTheirNumbers()
    {
        KeptStudy study = referencedStudy(StudyKind::TypeOne, {u"9000"_s}, 50);
        study.options.tolerances[2] = 1000;
        const QString bias = resultOf(study)->verdict[1].describe();
        QVERIFY2(bias.contains(u"N/m"_s), qPrintable(bias));
        for (StudyMeasurementRecord& one : study.measurements)
            one.measured.units[2] = u"counts/m"_s; // of a gripper whose units are not known
        QVERIFY(!resultOf(study)->verdict[1].describe().contains(u"N/m"_s));
    }
    void readingsStandBesideTheirReferences()
    {
        const KeptStudy study = referencedStudy(StudyKind::Linearity, {u"9000"_s, u"10000"_s, u"11000"_s}, 4);
        const ReferencedReadings readings = referencedReadings(study).value();
        QCOMPARE(readings.values.size(), std::size_t(12));
        QCOMPARE(readings.unit, u"N/m"_s);
        QVERIFY(readings.quantity == MechanicalQuantity::Stiffness);
        for (std::size_t row = 0; row < readings.values.size(); ++row)
            QCOMPARE(readings.references[row], study.plan.reference(row).toDouble());
        const auto result = resultOf(study);
        QVERIFY(result && result->as<LinearityResult>() && !result->verdict.empty());
        QCOMPARE(result->as<LinearityResult>()->study.references.size(), std::size_t(3));
    }
    /// Readings that do not follow their references at all: chance does not do that, but p is no zero.
    void noProbabilityIsNothing()
    {
        const KeptStudy study =
            referencedStudy(StudyKind::Linearity, {u"5000"_s, u"10000"_s, u"15000"_s}, 12);
        const QString words = firstSentence(resultOf(study));
        QVERIFY2(words.contains(u"p < 0.001"_s), qPrintable(words));
    }
    void whatIsNotDeterminedIsAnError()
    {
        KeptStudy study = referencedStudy(StudyKind::Linearity, {u"9000"_s, u"11000"_s}, 4);
        study.measurements[3].measured.values[2].reset();
        QVERIFY(resultOf(study).error().code == ErrorCode::BadInput);
        study.measurements.clear();
        QVERIFY(resultOf(study).error().code == ErrorCode::BadInput);
    }
    void ratersWhoAlwaysAgreeDo()
    {
        const auto result = resultOf(ratedStudy({u"Ada"_s, u"Bo"_s}));
        QVERIFY(result && result->as<AttributeAgreement>());
        QCOMPARE(result->as<AttributeAgreement>()->fleiss.value, std::optional(1.0));
    }
    void aRaterWhomThePlanDoesNotNameIsWhoWasThere()
    {
        KeptStudy study = ratedStudy({});
        QVERIFY(firstSentence(resultOf(study)).contains(u"agree"_s));
        QCOMPARE(resultOf(study)->as<AttributeAgreement>()->raters.front().name, u"-"_s);
        for (StudyMeasurementRecord& one : study.measurements)
            one.measured.operatorName = u"Mai"_s;
        const auto result = resultOf(study);
        QCOMPARE(result->as<AttributeAgreement>()->raters.front().name, u"Mai"_s);
        QVERIFY(studyCsv(study).startsWith("part,operator,"));
        QVERIFY(studyTable(study).columns().contains(u"operator"_s));
    }
    void aGaugeStudyHasItsComponentsAndCombinations()
    {
        const auto result = resultOf(madeStudy(crossedDesign(10, {u"Ada"_s, u"Bo"_s}, 3), {0.05, 0, 0.002}));
        QVERIFY(result && result->gauge());
        QCOMPARE(result->gauge()->quantities.size(), std::size_t(3));
        const QString combinations = result->verdict[3].describe();
        QVERIFY2(combinations.startsWith(u"By m, b, k together it tells more than 50 combinations"_s),
                 qPrintable(combinations));
    }
};
GRIPSCOPE_TEST(ResultOfEachKindTest)
#include "result_of_each_kind_test.moc"
