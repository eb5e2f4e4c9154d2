// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/bias/bias_json.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

struct LinearityData {
    std::vector<double> references, values;
};

/// AIAG's example: five references, twelve readings each.
LinearityData aiagLinearity()
{
    const std::vector<std::pair<double, std::vector<double>>> rows{
        {2, {2.7, 2.5, 2.4, 2.5, 2.7, 2.3, 2.5, 2.5, 2.4, 2.4, 2.6, 2.4}},
        {4, {5.1, 3.9, 4.2, 5.0, 3.8, 3.9, 3.9, 3.9, 3.9, 4.0, 4.1, 3.8}},
        {6, {5.8, 5.7, 5.9, 5.9, 6.0, 6.1, 6.0, 6.1, 6.4, 6.3, 6.0, 6.1}},
        {8, {7.6, 7.7, 7.8, 7.7, 7.8, 7.8, 7.8, 7.7, 7.8, 7.5, 7.6, 7.7}},
        {10, {9.1, 9.3, 9.5, 9.3, 9.4, 9.5, 9.5, 9.5, 9.6, 9.2, 9.3, 9.4}}};
    LinearityData data;
    for (const auto& [reference, values] : rows)
        for (const double value : values) {
            data.references.push_back(reference);
            data.values.push_back(value);
        }
    return data;
}

Expected<LinearityStudy> studyOf(const LinearityData& data, const LinearityOptions& options = {})
{
    return studyLinearity(data.references, data.values, options);
}

bool nearTo(double found, double expected, double absolute)
{
    return std::abs(found - expected) <= absolute;
}

bool says(const LinearityStudy& study, const QString& words)
{
    return english(study.messages).join(u' ').contains(words);
}

} // namespace

class LinearityStudyTest : public QObject {
    Q_OBJECT
private slots:
    /// To the digits printed.
    void theExampleComesOut()
    {
        const auto study = studyOf(aiagLinearity());
        QVERIFY(study);
        QVERIFY(nearTo(study->intercept, 0.7366667, 5e-8));
        QVERIFY(nearTo(study->slope, -0.1316667, 5e-8));
        QVERIFY(nearTo(*study->tIntercept, 10.1575, 5e-5));
        QVERIFY(nearTo(*study->tSlope, -12.0426, 5e-5));
        QVERIFY(nearTo(*study->residualDeviation, 0.2395398, 5e-8));
        QVERIFY(nearTo(*study->rSquared, 0.7143, 5e-5));
        const std::vector<double> biases{.491667, .125, .025, -.291667, -.616667};
        QCOMPARE(study->references.size(), biases.size());
        for (std::size_t i = 0; i < biases.size(); ++i)
            QVERIFY(nearTo(study->references[i].bias, biases[i], 5e-7));
        QVERIFY(nearTo(study->percentLinearity, 13.1667, 5e-5));
        QVERIFY(says(*study, u"Not linear"_s) && says(*study, u"references 2, 8, 10"_s));
    }
    /// By R 4.2: lm(), anova(), predict(), t.test().
    void agreesWithR()
    {
        const auto study = studyOf(aiagLinearity());
        QVERIFY(study);
        QVERIFY(nearTo(*study->pIntercept / 1.7338e-14, 1, 1e-4));
        const std::vector<double> p{2.872333e-08, 0.3539913, 0.6671307, 6.419481e-07, 1.554445e-08};
        for (std::size_t i = 0; i < p.size(); ++i)
            QVERIFY(nearTo(*study->references[i].p / p[i], 1, 1e-6));
        QVERIFY(nearTo(study->lackOfFit->f, 1.0977, 5e-5) && nearTo(study->lackOfFit->p, 0.3579, 5e-5));
        QVERIFY(nearTo(study->zeroLine->f, 73.999, 5e-4));
        QVERIFY(nearTo(study->references[1].band->lower, 0.1341858, 5e-8));
        QVERIFY(nearTo(study->references[1].band->upper, 0.2858142, 5e-8));
        QVERIFY(nearTo(study->bandAt(10)->lower, -0.6872174, 5e-8));
    }
    void thePooledDeviationIsForThoseWhoScatterAlike()
    {
        LinearityOptions options;
        options.deviation = BiasDeviation::Pooled;
        const auto study = studyOf(aiagLinearity(), options);
        QVERIFY(study);
        const std::vector<double> p{2.32580e-09, 0.0754082, 0.718405, 8.95439e-05, 2.63200e-12}; // R: pt()
        for (std::size_t i = 0; i < p.size(); ++i)
            QVERIFY(nearTo(*study->references[i].p / p[i], 1, 1e-5));
    }
    /// Minitab: linearity 1.86889 and 13.2 % of a process variation of 14.1941; bias -0.053333, 0.4 %.
    void theProcessVariationGivesLinearityItsUnit()
    {
        LinearityOptions options;
        options.processVariation = 14.1941;
        const auto study = studyOf(aiagLinearity(), options);
        QVERIFY(study);
        QVERIFY(nearTo(*study->linearity, 1.86889, 5e-6));
        QVERIFY(nearTo(100 * *study->linearity / 14.1941, study->percentLinearity, 1e-12));
        QVERIFY(nearTo(study->average.bias, -0.053333, 5e-7));
        QVERIFY(nearTo(*study->average.percentBias, 0.4, 0.05));
        QVERIFY(says(*study, u"1.869"_s));
    }
    void orderUnitAndOffsetChangeNothingThatTheyShouldNot()
    {
        const LinearityData data = aiagLinearity();
        const auto study = studyOf(data);
        LinearityData other = data;
        std::reverse(other.references.begin(), other.references.end());
        std::reverse(other.values.begin(), other.values.end());
        for (std::size_t i = 0; i < other.values.size(); ++i) {
            other.references[i] = 1e6 + 1e3 * other.references[i];
            other.values[i] = 1e6 + 1e3 * other.values[i];
        }
        const auto moved = studyOf(other);
        QVERIFY(moved);
        QVERIFY(nearTo(moved->slope, study->slope, 1e-10));
        QVERIFY(nearTo(*moved->tSlope, *study->tSlope, 1e-7));
        QVERIFY(nearTo(*moved->residualDeviation / 1e3, *study->residualDeviation, 1e-9));
        QVERIFY(nearTo(moved->lackOfFit->p, study->lackOfFit->p, 1e-7));
    }
    void aBentBiasDoesNotFitALine()
    {
        LinearityData data;
        for (const double reference : {1.0, 2.0, 3.0, 4.0, 5.0})
            for (const double scatter : {-0.01, 0.0, 0.01}) {
                data.references.push_back(reference);
                data.values.push_back(reference + 0.1 * (reference - 3) * (reference - 3) + scatter);
            }
        const auto study = studyOf(data);
        QVERIFY(study && study->lackOfFit->p < 1e-6);
        QVERIFY(nearTo(study->slope, 0, 1e-12));
        QVERIFY(says(*study, u"lack of fit"_s));
        QCOMPARE(study->lackOfFit->numerator, 3.0);
        QCOMPARE(study->lackOfFit->denominator, 10.0);
    }
    void aBiasThatIsTheSameEverywhereIsSeenAsOne()
    {
        LinearityData data;
        for (const double reference : {1.0, 2.0, 3.0})
            for (const double scatter : {-0.01, 0.0, 0.01}) {
                data.references.push_back(reference);
                data.values.push_back(reference + 0.5 + scatter);
            }
        const auto study = studyOf(data);
        QVERIFY(study && *study->pSlope > 0.99 && study->zeroLine->p < 1e-6);
        QVERIFY(says(*study, u"Linear, but biased"_s) && says(*study, u"There are 3 references"_s));
    }
    void withoutScatterNothingIsTested()
    {
        LinearityData data;
        for (const double reference : {1.0, 2.0, 3.0, 7.0})
            for (int i = 0; i < 3; ++i) {
                data.references.push_back(reference);
                data.values.push_back(1.1 * reference + 0.3);
            }
        const auto study = studyOf(data);
        QVERIFY(study);
        QVERIFY(nearTo(study->slope, 0.1, 1e-12) && nearTo(study->intercept, 0.3, 1e-12));
        QVERIFY(!study->residualDeviation && !study->tSlope && !study->pSlope && !study->lackOfFit);
        QVERIFY(nearTo(*study->rSquared, 1, 1e-12) && !study->references[0].p && !study->bandAt(2));
        QVERIFY(says(*study, u"without any scatter"_s) && says(*study, u"repeat the readings"_s));
        QVERIFY(toJson(*study)[u"t_slope"_s].isNull());
        const auto two = studyLinearity(std::vector<double>{1, 2}, std::vector<double>{1.1, 2.3});
        QVERIFY(two && nearTo(two->slope, 0.2, 1e-12) && !two->pSlope && !two->average.p);
        const auto equal = studyLinearity(std::vector<double>{1, 2, 3}, std::vector<double>{1, 2, 3});
        QVERIFY(equal && equal->slope == 0 && !equal->rSquared && !equal->zeroLine);
    }
    void oneReadingAReferenceHasATestBySlopeOnly()
    {
        const auto study =
            studyLinearity(std::vector<double>{1, 2, 3, 4}, std::vector<double>{1.1, 2, 3.1, 4});
        QVERIFY(study && study->pSlope && !study->lackOfFit && !study->pooledDeviation);
        QVERIFY(!study->references[0].p && study->references[0].band);
    }
    void whatMakesNoSenseIsRefused()
    {
        const auto oneReference = studyLinearity(std::vector<double>{1, 1}, std::vector<double>{1, 2});
        QVERIFY(!oneReference && oneReference.error().describe().contains(u"type-1"_s));
        QVERIFY(!studyLinearity(std::vector<double>{}, std::vector<double>{}));
        QVERIFY(!studyLinearity(std::vector<double>{1, 2}, std::vector<double>{1}));
        QVERIFY(!studyLinearity(std::vector<double>{1, std::nan("")}, std::vector<double>{1, 2}));
        QVERIFY(!studyLinearity(std::vector<double>{-1e308, 1e308}, std::vector<double>{1, 1e308}));
        QVERIFY(!studyLinearity(std::vector<double>{1e-200, 2e-200}, std::vector<double>{1, 2}));
        LinearityOptions options;
        options.processVariation = 0;
        QVERIFY(studyOf(aiagLinearity(), options).error().code == ErrorCode::Usage);
    }
};

GRIPSCOPE_TEST(LinearityStudyTest)
#include "linearity_study_test.moc"
