// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/quality/charts/run_length.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

class RunLengthTest : public QObject {
    Q_OBJECT
private:
    static bool near(const std::optional<RunLength>& length, double expected, double tolerance)
    {
        return length && std::abs(length->points - expected) <= tolerance;
    }
    /// The chart itself, on normal numbers.
    static RunLength simulated(const ChartSetting& setting, double shift, int runs)
    {
        RandomStream random(7, 0, 0);
        double sum = 0, squares = 0;
        for (int run = 0; run < runs; ++run) {
            LiveChart chart = LiveChart::of(setting).value();
            double length = 1;
            while (chart.add(setting.centre + setting.sigma * (shift + random.normal()))->location.rules == 0)
                ++length;
            sum += length;
            squares += length * length;
        }
        return {sum / runs, std::sqrt((squares / runs - sum * sum / runs / runs) / runs)};
    }

private slots:
    /// Montgomery, table 9.3 and section 9.1: 465 and 10.4; digits by R's spc 0.6.7.
    void cusumIsThePublishedOne()
    {
        QVERIFY(near(twoSidedCusumRunLength(0.5, 5, 0), 465.4435, 5e-4));
        QVERIFY(near(twoSidedCusumRunLength(0.5, 5, 1), 10.37597, 5e-5));
        QVERIFY(near(cusumRunLength(0.5, 5, 0), 930.887, 5e-3));
    }
    /// Lucas and Saccucci 1990: 2.814 gives 500 at a weight of 0.1, and 2.703 gives 370.
    void ewmaIsThePublishedOne_data()
    {
        QTest::addColumn<double>("weight");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("fixedLimits");
        QTest::addColumn<double>("exactLimits"); // R's spc, limits = "vacl"
        QTest::newRow("0.1, 2.814") << 0.1 << 2.814 << 499.5796 << 486.4293;
        QTest::newRow("0.1, 2.703") << 0.1 << 2.703 << 371.8878 << 358.9822;
        QTest::newRow("0.2, 3") << 0.2 << 3.0 << 559.8741 << 554.4875;
        QTest::newRow("0.05, 2.615") << 0.05 << 2.615 << 499.9330 << 469.4799;
        QTest::newRow("0.01, 2") << 0.01 << 2.0 << 527.5684 << 353.0822;
        QTest::newRow("Shewhart's") << 1.0 << 3.0 << 370.3983 << 370.3983;
    }
    void ewmaIsThePublishedOne()
    {
        QFETCH(double, weight);
        QFETCH(double, width);
        QFETCH(double, fixedLimits);
        QFETCH(double, exactLimits);
        QVERIFY(near(ewmaRunLength(weight, width, 0, EwmaLimits::Fixed), fixedLimits, 1e-4));
        QVERIFY(near(ewmaRunLength(weight, width, 0), exactLimits, 1e-4));
    }
    /// Champ and Woodall 1987: 370.40 and 43.89; 91.75 and 9.22.
    void shewhartIsThePublishedOne()
    {
        QVERIFY(near(shewhartRunLength(RunRules::None, 0), 370.40, 0.005));
        QVERIFY(near(shewhartRunLength(RunRules::None, 1), 43.89, 0.005));
        QVERIFY(near(shewhartRunLength(RunRules::WesternElectric, 0), 91.75, 0.005));
        QVERIFY(near(shewhartRunLength(RunRules::WesternElectric, 1), 9.22, 0.005));
        QCOMPARE(shewhartRunLength(RunRules::WesternElectric, -0.7).points,
                 shewhartRunLength(RunRules::WesternElectric, 0.7).points);
    }
    /// What is stated of a chart is how the chart runs: within 4 standard errors.
    void theChartRunsAsStated_data()
    {
        QTest::addColumn<ChartSetting>("setting");
        ChartSetting setting{ChartKind::Individuals, 10, 2, RunRules::WesternElectric, 0.2, 3, 0.5, 5, 1};
        QTest::newRow("Western Electric") << setting;
        setting.rules = RunRules::Nelson;
        QTest::newRow("Nelson") << setting;
        setting.kind = ChartKind::Ewma;
        setting.width = 2.5;
        QTest::newRow("EWMA") << setting;
        setting.kind = ChartKind::Cusum;
        setting.decision = 4;
        QTest::newRow("CUSUM") << setting;
    }
    void theChartRunsAsStated()
    {
        QFETCH(ChartSetting, setting);
        const RunLengths stated = runLengths(setting);
        for (const double shift : {0.0, 1.0}) {
            const RunLength found = simulated(setting, shift, 20'000);
            const RunLength& told = shift > 0 ? *stated.shifted : *stated.inControl;
            QVERIFY2(std::abs(found.points - told.points) <
                         4 * std::hypot(found.standardError, told.standardError),
                     qPrintable(QStringLiteral("%1 stated, %2 +- %3 found")
                                    .arg(told.points)
                                    .arg(found.points)
                                    .arg(found.standardError)));
        }
    }
    void aMeanOfFourSeesTwiceTheShift()
    {
        ChartSetting setting;
        setting.kind = ChartKind::MeanRange;
        setting.size = 4;
        QCOMPARE(runLengths(setting).shifted->points, shewhartRunLength(RunRules::None, 2).points);
    }
    void whatCannotBeToldIsNot()
    {
        QVERIFY(!ewmaRunLength(0.1, 12, 0));
        QVERIFY(!ewmaRunLength(0.001, 3, 0));
        QVERIFY(!cusumRunLength(0.5, 60, 0));
        QVERIFY(!cusumRunLength(0.5, 1e9, 0));
        QVERIFY(!cusumRunLength(0.5, 5, std::nan("")));
        QVERIFY(near(cusumRunLength(0.5, 5, 50), 1, 1e-9));
        QVERIFY(near(twoSidedCusumRunLength(0.5, 20, 2), 14.1, 0.5)); // (h + 1.166)/(2 - k)
    }
};

GRIPSCOPE_TEST(RunLengthTest)
#include "run_length_test.moc"
