// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/math/sample_moments.h"
#include "core/quality/bias/bias_json.h"
#include "core/quality/bias/type_one_study.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

bool nearTypeOne(double found, double expected, double relative = 1e-9)
{
    return std::abs(found - expected) <= relative * std::abs(expected);
}

/// Half of them `distance` below, half above: s = distance sqrt(n / (n - 1)).
std::vector<double> twoValued(double mean, double distance, int count)
{
    std::vector<double> readings;
    for (int i = 0; i < count; ++i)
        readings.push_back(mean + (i % 2 == 0 ? distance : -distance));
    return readings;
}

TypeOneOptions withTolerance(double reference, double tolerance)
{
    TypeOneOptions options;
    options.reference = reference;
    options.tolerance = tolerance;
    return options;
}

bool says(const TypeOneStudy& study, const QString& words)
{
    return english(study.messages).join(u' ').contains(words);
}

} // namespace

class TypeOneStudyTest : public QObject {
    Q_OBJECT
private slots:
    void bookletTensFormulas()
    {
        const double s = 0.01 * std::sqrt(50.0 / 49);
        const auto study = studyTypeOne(twoValued(10.004, 0.01, 50), withTolerance(10, 1));
        QVERIFY(study);
        QVERIFY(nearTypeOne(study->repeatability, s));
        QVERIFY(nearTypeOne(study->bias, 0.004));
        QVERIFY(nearTypeOne(*study->cg, 0.2 * 1 / (6 * s)));
        QVERIFY(nearTypeOne(*study->cgk, (0.1 * 1 - 0.004) / (3 * s)));
        QVERIFY(nearTypeOne(*study->t, 0.004 * std::sqrt(50) / s));
        QVERIFY(nearTypeOne(study->variationPercent, 100 * 6 * s));
        QVERIFY(nearTypeOne(study->variationPercent, 20 / *study->cg));
        QVERIFY(nearTypeOne(*study->biasedVariationPercent, 20 / *study->cgk));
        QVERIFY(study->capable && study->biased);
        QVERIFY(says(*study, u"Capable"_s) && says(*study, u"too much"_s));
    }
    void shareAndSigmasAreThoseAskedFor()
    {
        TypeOneOptions options = withTolerance(10, 1);
        options.sharePercent = 15;
        options.sigmas = 4;
        const auto study = studyTypeOne(twoValued(9.99, 0.01, 50), options);
        QVERIFY(study);
        QVERIFY(nearTypeOne(*study->cg, 0.15 / (4 * study->repeatability)));
        QVERIFY(nearTypeOne(*study->cgk, (0.075 - 0.01) / (2 * study->repeatability), 1e-8));
    }
    /// By R 4.2: t.test(), qchisq() and uniroot() over pt(..., ncp), of 20 volumes (capability.csv).
    void agreesWithR()
    {
        const std::vector<double> volumes{755.81, 750.54, 751.05, 749.52, 749.21, 748.38, 748.11,
                                          753.07, 749.56, 750.08, 747.16, 747.53, 749.22, 746.76,
                                          747.64, 750.46, 749.27, 750.33, 750.26, 751.29};
        const auto study = studyTypeOne(volumes, withTolerance(750, 40));
        QVERIFY(study);
        QVERIFY(nearTypeOne(study->repeatability, 2.104196, 1e-6));
        QVERIFY(nearTypeOne(*study->t, -0.50477, 1e-5) && nearTypeOne(*study->p, 0.6195, 1e-4));
        QVERIFY(nearTypeOne(study->biasInterval->lower, 748.7777 - 750, 1e-4));
        QVERIFY(nearTypeOne(study->biasInterval->upper, 750.7473 - 750, 1e-4));
        QVERIFY(nearTypeOne(*study->cg, 0.6336545, 1e-6) && nearTypeOne(*study->cgk, 0.5960313, 1e-6));
        QVERIFY(nearTypeOne(study->cgInterval->lower, 0.4338401, 1e-6));
        QVERIFY(nearTypeOne(study->cgInterval->upper, 0.8332183, 1e-6));
        QVERIFY(nearTypeOne(study->cgkInterval->lower, 0.35487520, 1e-6));
        QVERIFY(nearTypeOne(study->cgkInterval->upper, 0.83116641, 1e-6));
        QVERIFY(!study->capable && !study->biased);
        QVERIFY(says(*study, u"scatter too much"_s) && says(*study, u"20 readings are few"_s));
    }
    void theLeastToleranceReachesTheMinimum()
    {
        const std::vector<double> readings = twoValued(10.02, 0.03, 30);
        const auto first = studyTypeOne(readings, withTolerance(10, 1));
        const auto scatter = studyTypeOne(readings, withTolerance(10, first->leastTolerance));
        const auto both = studyTypeOne(readings, withTolerance(10, first->leastBiasedTolerance));
        QVERIFY(nearTypeOne(*scatter->cg, 1.33) && nearTypeOne(*both->cgk, 1.33));
        QVERIFY(nearTypeOne(scatter->variationPercent, scatter->largestVariationPercent));
    }
    void intervalsHoldAsOftenAsStated_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("bias"); // in standard deviations
        QTest::newRow("few, unbiased") << 10 << 0.0;
        QTest::newRow("few, biased") << 10 << 0.5;
        QTest::newRow("usual, slightly biased") << 50 << 0.05;
        QTest::newRow("usual, beyond the limit") << 50 << 5.0;
    }
    void intervalsHoldAsOftenAsStated()
    {
        QFETCH(int, count);
        QFETCH(double, bias);
        constexpr int runs = 2000;
        const double cg = 4.0 / 3, cgk = (4 - std::abs(bias)) / 3; // T = 40 sigma
        int holdsBias = 0, holdsDeviation = 0, holdsCg = 0, holdsCgk = 0;
        const auto within = [](const std::optional<TwoSidedInterval>& interval, double truth) {
            return interval->lower <= truth && truth <= interval->upper ? 1 : 0;
        };
        for (int run = 0; run < runs; ++run) {
            RandomStream random(5, std::uint64_t(run), std::uint64_t(count));
            std::vector<double> readings;
            for (int i = 0; i < count; ++i)
                readings.push_back(bias + random.normal());
            const auto study = studyTypeOne(readings, withTolerance(0, 40));
            QVERIFY(study);
            holdsBias += within(study->biasInterval, bias);
            holdsDeviation += within(study->repeatabilityInterval, 1);
            holdsCg += within(study->cgInterval, cg);
            holdsCgk += within(study->cgkInterval, cgk);
        }
        // 95 % +- 3 standard errors of 2000 runs, and what |bias| costs (93 to 96 %, see the header).
        for (const int held : {holdsBias, holdsDeviation, holdsCg})
            QVERIFY2(held >= 0.935 * runs && held <= 0.965 * runs, qPrintable(QString::number(held)));
        QVERIFY2(holdsCgk >= 0.92 * runs && holdsCgk <= 0.975 * runs, qPrintable(QString::number(holdsCgk)));
    }
    void theIntervalOfCgkHasNoSeamWhereTheShiftGrowsLarge()
    {
        const double before = 1000.0 / (std::sqrt(20.0) * 3) * 0.9999;
        const auto exact = biasedCapabilityInterval(before, 6, 20, 0.95);
        const auto limit = capabilityInterval(before, 20, 0.95);
        QVERIFY(nearTypeOne(exact->lower, limit->lower, 1e-5) &&
                nearTypeOne(exact->upper, limit->upper, 1e-5));
    }
    void equalReadingsHaveNoIndex()
    {
        const auto study = studyTypeOne(std::vector<double>(30, 10.01), withTolerance(10, 1));
        QVERIFY(study);
        QCOMPARE(study->repeatability, 0.0);
        QVERIFY(!study->cg && !study->cgk && !study->t && !study->p && !study->biasInterval && !study->step);
        QVERIFY(!study->capable && study->biased);
        QVERIFY(says(*study, u"more digits"_s));
        QVERIFY(toJson(*study)[u"cg"_s].isNull() && toJson(*study)[u"bias_interval"_s].isNull());
        const auto off = studyTypeOne(std::vector<double>(30, 10.2), withTolerance(10, 1));
        QVERIFY(says(*off, u"Calibrate"_s));
    }
    void twoReadingsAreEnoughToCalculate()
    {
        const auto study = studyTypeOne(std::vector<double>{9.9, 10.1}, withTolerance(10, 1));
        QVERIFY(study && study->cg && study->cgkInterval && study->biasInterval);
        QVERIFY(nearTypeOne(study->repeatability, 0.2 / std::sqrt(2)));
        QVERIFY(nearTypeOne(study->biasInterval->upper, 12.7062047362 * 0.1, 1e-9));
        QVERIFY(says(*study, u"few"_s));
    }
    void aBiasBeyondTheShareMakesCgkNegative()
    {
        const auto study = studyTypeOne(twoValued(10.5, 0.01, 50), withTolerance(10, 1));
        QVERIFY(study && *study->cgk < 0 && study->cgkInterval->lower < *study->cgk);
        QVERIFY(study->cgkInterval->upper > *study->cgk && !study->biasedVariationPercent);
        QVERIFY(says(*study, u"the bias is not"_s));
    }
    void aCoarseStepIsSaid()
    {
        std::vector<double> readings(49, 10.0);
        readings.push_back(10.1); // s = 0.0141, Cg 2.36
        const auto study = studyTypeOne(readings, withTolerance(10, 1));
        QVERIFY(study && *study->cg > 1.33 && *study->cgk > 1.33);
        QVERIFY(nearTypeOne(*study->stepPercent, 10, 1e-9));
        QVERIFY(!study->capable && says(*study, u"finer sensor"_s));
    }
    void leadingDigitsCostNothing()
    {
        // NIST's NumAcc4: 10000000.2, then 10000000.1 and 10000000.3 five hundred times; s = 0.1.
        std::vector<double> readings{10000000.2};
        for (int i = 0; i < 1000; ++i)
            readings.push_back(i % 2 == 0 ? 10000000.1 : 10000000.3);
        const SampleMoments moments = sampleMoments(readings);
        QVERIFY(nearTypeOne(moments.mean, 10000000.2, 1e-15));
        QVERIFY(nearTypeOne(moments.standardDeviation, 0.1, 3e-8)); // as well as a double holds the readings
        // Where squares are beyond a double, but deviations are not.
        for (const double unit : {1e-200, 1e200}) {
            const std::vector<double> scaled{unit, 2 * unit, 3 * unit};
            QVERIFY(nearTypeOne(sampleMoments(scaled).standardDeviation, unit));
        }
    }
    void whatMakesNoSenseIsRefused()
    {
        const std::vector<double> readings{1, 2, 3};
        TypeOneOptions options = withTolerance(2, 0);
        QVERIFY(studyTypeOne(readings, options).error().code == ErrorCode::Usage);
        options = withTolerance(std::nan(""), 1);
        QVERIFY(studyTypeOne(readings, options).error().code == ErrorCode::Usage);
        options = withTolerance(2, 1);
        options.sharePercent = 101;
        QVERIFY(studyTypeOne(readings, options).error().code == ErrorCode::Usage);
        for (const std::vector<double>& bad :
             {std::vector<double>{}, std::vector<double>{1}, std::vector<double>{1, std::nan("")},
              std::vector<double>{1e308, -1e308}}) {
            const auto study = studyTypeOne(bad, withTolerance(2, 1));
            QVERIFY(!study && study.error().code == ErrorCode::BadInput);
        }
    }
};

GRIPSCOPE_TEST(TypeOneStudyTest)
#include "type_one_study_test.moc"
