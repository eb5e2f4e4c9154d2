// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/math/normal_spread.h"
#include "core/quality/charts/chart_constants.h"
#include "core/quality/charts/within_spread.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>

using namespace gripscope;

class ChartConstantsTest : public QObject {
    Q_OBJECT
private slots:
    /// Harter 1960 and ASTM MNL 7.
    void areTheTabulatedOnes_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<double>("d2");
        QTest::addColumn<double>("d3");
        QTest::addColumn<double>("c4");
        QTest::addColumn<double>("A2");
        QTest::addColumn<double>("D4");
        QTest::newRow("2") << 2 << 1.128379167 << 0.852502466 << 0.797884561 << 1.880 << 3.267;
        QTest::newRow("3") << 3 << 1.692568751 << 0.888368004 << 0.886226925 << 1.023 << 2.574;
        QTest::newRow("5") << 5 << 2.325928947 << 0.864081941 << 0.939985603 << 0.577 << 2.114;
        QTest::newRow("10") << 10 << 3.077505462 << 0.797050674 << 0.972659274 << 0.308 << 1.777;
        QTest::newRow("25") << 25 << 3.930629220 << 0.708440766 << 0.989640376 << 0.153 << 1.541;
    }
    void areTheTabulatedOnes()
    {
        QFETCH(int, size);
        QFETCH(double, d2);
        QFETCH(double, d3);
        QFETCH(double, c4);
        QFETCH(double, A2);
        QFETCH(double, D4);
        const ChartConstants found = chartConstants(size);
        QVERIFY(std::abs(found.d2 - d2) < 1e-9);
        QVERIFY(std::abs(found.d3 - d3) < 1e-9);
        QVERIFY(std::abs(found.c4 - c4) < 1e-9);
        QVERIFY(std::abs(found.A2() - A2) < 6e-4);
        QVERIFY(std::abs(found.D4() - D4) < 1.1e-3);
    }
    void haveTheClosedForms()
    {
        const double pi = std::numbers::pi;
        QVERIFY(std::abs(chartConstants(2).d2 - 2 / std::sqrt(pi)) < 1e-12);
        QVERIFY(std::abs(chartConstants(2).d3 - std::sqrt(2 - 4 / pi)) < 1e-10);
        QVERIFY(std::abs(chartConstants(3).d2 - 3 / std::sqrt(pi)) < 1e-12);
        QVERIFY(std::abs(chartConstants(2).c4 - std::sqrt(2 / pi)) < 1e-14);
        QVERIFY(std::abs(deviationBias(1e6) - (1 - 0.25e-6)) < 1e-12);
    }
    void holdForRangesThatAreDrawn()
    {
        constexpr int size = 7, draws = 100'000;
        RandomStream random(3, 0, 0);
        double sum = 0, squares = 0;
        for (int i = 0; i < draws; ++i) {
            std::array<double, size> values{};
            for (double& value : values)
                value = random.normal();
            const double range = summaryOf(values).range;
            sum += range;
            squares += range * range;
        }
        const ChartConstants found = chartConstants(size);
        const double mean = sum / draws;
        QVERIFY(std::abs(mean - found.d2) < 4 * found.d3 / std::sqrt(draws));
        QVERIFY(std::abs(std::sqrt(squares / draws - mean * mean) / found.d3 - 1) < 0.015);
    }
    /// Sigma is unbiased and varies as it says, by each method, with subgroups of unequal size too.
    void theSpreadIsWorthItsDegreesOfFreedom_data()
    {
        QTest::addColumn<int>("method");
        QTest::addColumn<int>("size");
        QTest::newRow("moving ranges") << int(SpreadMethod::MovingRange) << 1;
        QTest::newRow("ranges") << int(SpreadMethod::Range) << 5;
        QTest::newRow("deviations") << int(SpreadMethod::Deviation) << 5;
        QTest::newRow("unequal ranges") << int(SpreadMethod::Range) << 0;
        QTest::newRow("unequal deviations") << int(SpreadMethod::Deviation) << 0;
    }
    void theSpreadIsWorthItsDegreesOfFreedom()
    {
        QFETCH(int, method);
        QFETCH(int, size);
        std::vector<int> labels;
        for (int i = 0; i < 60; ++i)
            labels.push_back(size > 0 ? i / size : int(std::sqrt(double(i))));
        const SubgroupLayout layout = SubgroupLayout::labelled(labels, std::size_t(labels.back()) + 1);
        RandomStream random(11, 0, 0);
        constexpr int draws = 3000;
        double sum = 0, squares = 0, degrees = 0;
        for (int i = 0; i < draws; ++i) {
            std::vector<double> values;
            for (int row = 0; row < 60; ++row)
                values.push_back(100 + 2 * random.normal());
            const WithinSpread spread =
                withinSpread(Subgroups::of(layout, values).value(), SpreadMethod(method)).value();
            sum += spread.sigma / 2;
            squares += spread.sigma * spread.sigma / 4;
            degrees = spread.degreesOfFreedom;
        }
        const double mean = sum / draws;
        const double bias = deviationBias(degrees);
        const double expected = 1 / (bias * bias) - 1;
        QVERIFY2(std::abs(mean - 1) < 4 * std::sqrt(expected / draws), qPrintable(QString::number(mean)));
        const double found = squares / draws / (mean * mean) - 1;
        QVERIFY2(std::abs(found / expected - 1) < 0.12, qPrintable(QString::number(found / expected)));
    }
};

GRIPSCOPE_TEST(ChartConstantsTest)
#include "chart_constants_test.moc"
