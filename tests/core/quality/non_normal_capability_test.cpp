// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/math/sorted_values.h"
#include "core/quality/charts/box_cox.h"
#include "core/quality/charts/percentile_capability.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;

class NonNormalCapabilityTest : public QObject {
    Q_OBJECT
private:
    static Subgroups rowByRow(const std::vector<double>& values)
    {
        return Subgroups::of(SubgroupLayout::consecutive(values.size(), 1).value(), values).value();
    }
    static std::vector<double> logNormal(RandomStream& random, int count)
    {
        std::vector<double> values;
        for (int i = 0; i < count; ++i)
            values.push_back(std::exp(0.5 * random.normal()));
        return values;
    }

private slots:
    /// optimize() over the log-likelihood in R 4.2.
    void thePowerIsTheMostLikelyOne()
    {
        const std::vector<double> values{0.31, 1.9,  0.77, 0.12, 2.6,  0.55, 1.05, 0.42,
                                         3.9,  0.23, 0.9,  1.4,  0.66, 0.37, 5.2};
        QVERIFY(std::abs(bestBoxCox(values).value() + 0.0434338) < 2e-6);
        std::vector<double> scaled = values;
        for (double& value : scaled)
            value *= 1e6;
        QVERIFY(std::abs(bestBoxCox(scaled).value() + 0.0434338) < 2e-6);
        QCOMPARE(boxCox(3, 1), 2.0);
        QVERIFY(std::abs(boxCox(3, 1e-9) - std::log(3)) < 1e-8);
    }
    /// A lognormal's limits at -4 and 4 sigma of its logarithm: Pp 4/3 by the power, far from it as if
    /// normal.
    void aPowerMakesALogNormalNormal()
    {
        RandomStream random(2, 0, 0);
        const std::vector<double> values = logNormal(random, 4000);
        CapabilityOptions options;
        options.limits = {std::exp(-2.0), std::exp(2.0)};
        const TransformedCapability found = studyBoxCoxCapability(rowByRow(values), options).value();
        QVERIFY(std::abs(found.lambda) < 0.06);
        QVERIFY(std::abs(found.capability.overall.spread->value / (4.0 / 3) - 1) < 0.06);
        QVERIFY(found.capability.normality->p > 0.05);
        QVERIFY(studyCapability(rowByRow(values), options)->normality->p < 1e-6);
        options.limits.lower = 0;
        const TransformedCapability upper = studyBoxCoxCapability(rowByRow(values), options).value();
        QVERIFY(!upper.capability.overall.spread && !upper.capability.messages.empty());
    }
    /// Of a lognormal the percentiles are known: Ppk = (U - 1)/(exp(1.5 sigma...) - 1).
    void percentilesCoverTheTruth()
    {
        const double high = std::exp(0.5 * 2.99997699), low = 1 / high; // 99.865 % is z = 2.99998
        PercentileOptions options;
        options.limits = {0.1, 7};
        options.resamples = 400;
        const double spread = 6.9 / (high - low);
        const double nearest = std::min((7 - 1) / (high - 1), (1 - 0.1) / (1 - low));
        RandomStream random(8, 0, 0);
        int pp = 0, ppk = 0;
        constexpr int runs = 400;
        for (int run = 0; run < runs; ++run) {
            const PercentileCapability found =
                studyPercentileCapability(logNormal(random, 6000), options).value();
            pp += found.spread->interval.lower <= spread && spread <= found.spread->interval.upper;
            ppk += found.nearest.interval.lower <= nearest && nearest <= found.nearest.interval.upper;
        }
        QVERIFY2(pp > 0.9 * runs && pp < 0.985 * runs, qPrintable(QString::number(pp)));
        QVERIFY2(ppk > 0.9 * runs && ppk < 0.985 * runs, qPrintable(QString::number(ppk)));
    }
    void resamplesAreTheOrdinaryBootstrap()
    {
        RandomStream random(6, 0, 0);
        const std::vector<double> values = logNormal(random, 2000);
        PercentileOptions options;
        options.limits.upper = 7;
        const PercentileCapability found = studyPercentileCapability(values, options).value();
        std::vector<double> plain;
        for (int run = 0; run < 1500; ++run) {
            std::vector<double> resample;
            for (std::size_t i = 0; i < values.size(); ++i)
                resample.push_back(values[std::size_t(random.uniform() * double(values.size()))]);
            options.resamples = 200;
            plain.push_back(studyPercentileCapability(resample, options)->nearest.value);
        }
        std::sort(plain.begin(), plain.end());
        QVERIFY(std::abs(found.nearest.interval.lower / plain[37] - 1) < 0.04);
        QVERIFY(std::abs(found.nearest.interval.upper / plain[1462] - 1) < 0.04);
    }
    void theSameSeedGivesTheSame()
    {
        RandomStream random(6, 0, 0);
        const std::vector<double> values = logNormal(random, 500);
        PercentileOptions options;
        options.limits.upper = 7;
        const auto once = studyPercentileCapability(values, options);
        const auto twice = studyPercentileCapability(values, options);
        QCOMPARE(once->nearest.interval.lower, twice->nearest.interval.lower);
        QVERIFY(!once->messages.empty()); // too few for outer percentiles
        options.seed = 2;
        QVERIFY(studyPercentileCapability(values, options)->nearest.interval.lower !=
                once->nearest.interval.lower);
    }
    /// By digits as by comparing: of either sign, of any size, with ties.
    void manyAreSortedAsFewAre()
    {
        RandomStream random(8, 0, 0);
        for (const std::size_t count : {std::size_t(10), std::size_t(5000), std::size_t(60'000)}) {
            std::vector<double> values{0, 1e300, -1e300, 5e-324, -5e-324};
            while (values.size() < count)
                values.push_back(values.size() % 3 == 0 ? std::round(10 * random.normal())
                                                        : 9990 + 20 * random.normal());
            std::vector<double> expected = values;
            std::sort(expected.begin(), expected.end());
            QVERIFY(sortedValues(values) == expected);
        }
        QVERIFY(sortedValues({}).empty());
    }
    void ranksThatAreSharedGiveTheSame()
    {
        RandomStream random(9, 0, 0);
        PercentileOptions options;
        options.limits = {0.1, 9.0};
        options.resamples = 400;
        const std::vector<double> values = logNormal(random, 6000);
        const auto own = studyPercentileCapability(values, options);
        const auto shared =
            studyPercentileCapability(sortedValues(values), resampledRanks(6000, 400, options.seed), options);
        QVERIFY(own && shared);
        QCOMPARE(shared->nearest.value, own->nearest.value);
        QCOMPARE(shared->nearest.interval.lower, own->nearest.interval.lower);
        QCOMPARE(shared->spread->interval.upper, own->spread->interval.upper);
        QCOMPARE(shared->observedPpm, own->observedPpm);
    }
    void badInputIsSaid()
    {
        CapabilityOptions options;
        options.limits.upper = 5;
        const auto negative = studyBoxCoxCapability(rowByRow({1, 2, 3, -4, 5, 6, 7, 8, 9}), options);
        QVERIFY(!negative && negative.error().describe().contains(QStringLiteral("Value 4")));
        options.limits.upper = -5;
        QVERIFY(!studyBoxCoxCapability(rowByRow({1, 2, 3, 4, 5, 6, 7, 8, 9}), options));
        options.limits = {0, {}};
        QVERIFY(!studyBoxCoxCapability(rowByRow({1, 2, 3, 4, 5, 6, 7, 8, 9}), options));
        PercentileOptions percentiles;
        percentiles.limits.upper = 5;
        QVERIFY(!studyPercentileCapability(std::vector<double>{1, 2, 3}, percentiles));
        QVERIFY(!studyPercentileCapability(std::vector<double>(20, 1.0), percentiles));
        std::vector<double> mostlyOne(20, 1.0);
        mostlyOne[3] = 2;
        QVERIFY(!studyPercentileCapability(mostlyOne, percentiles));
        percentiles.limits = {};
        QVERIFY(!studyPercentileCapability(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}, percentiles));
    }
};

GRIPSCOPE_TEST(NonNormalCapabilityTest)
#include "non_normal_capability_test.moc"
