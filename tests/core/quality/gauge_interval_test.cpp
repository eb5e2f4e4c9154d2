// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/distributions.h"
#include "core/quality/gauge/pivotal_intervals.h"
#include "core/research/gauge_coverage.h"
#include "tests/core/quality/gauge_tables.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// Runs of each ratio: GRIPSCOPE_COVERAGE, or 400.
int coverageRuns()
{
    const int asked = qEnvironmentVariableIntValue("GRIPSCOPE_COVERAGE");
    return asked > 0 ? asked : 400;
}

/// Four standard deviations of counting, in percent.
double countingMargin(int runs)
{
    return 4 * 100 * std::sqrt(0.95 * 0.05 / runs);
}

constexpr std::array<const char*, coveredQuantities> quantityNames{
    "repeatability", "operator", "part_operator", "part", "gauge", "total", "categories"};

QString coverageText(const GaugeCoverageRow& row)
{
    QString text = u"ratio %1:"_s.arg(row.ratio);
    for (std::size_t q = 0; q < coveredQuantities; ++q)
        text += u" %1 %2 %"_s.arg(QLatin1String(quantityNames[q]))
                    .arg(row.percent(CoveredQuantity(q)), 0, 'f', 2);
    return text;
}

} // namespace

class GaugeIntervalTest : public QObject {
    Q_OBJECT
private slots:
    /// Repeatability alone is chi-squared; part over repeatability, of parts alone, is F.
    void exactIntervalsComeOut()
    {
        const std::vector<GaugeRow> rows = drawnCrossedRows(8, 1, 0, 4, {2, 0, 0, 0, 0, 1}, 3);
        const GaugeValue value = studyGauge(measurementsOf(rows))->values.front();
        const double squares = value.table[1].sumOfSquares, degrees = value.table[1].degreesOfFreedom;
        const VarianceInterval& repeatability = value.find(GaugeComponent::Repeatability)->interval;
        QVERIFY(
            isRelativelyNear(repeatability.lower, squares / chiSquaredQuantileAbove(0.025, degrees), 2e-3));
        QVERIFY(isRelativelyNear(*repeatability.upper, squares / chiSquaredQuantile(0.025, degrees), 2e-3));
        const double f = *value.table[0].f;
        const auto categories = [&](double quantile) { return std::sqrt(2 * (f / quantile - 1) / 4); };
        QVERIFY(isRelativelyNear(value.distinctCategoriesInterval.lower,
                                 categories(fisherQuantileAbove(0.025, 7, degrees)), 0.02));
        QVERIFY(isRelativelyNear(*value.distinctCategoriesInterval.upper,
                                 categories(fisherQuantile(0.025, 7, degrees)), 0.02));
    }
    void theyAreTheSameEachTimeAndHoldTheEstimate()
    {
        const GaugeValue once = studyGauge(measurementsOf(manualRows()))->values.front();
        const GaugeValue again = studyGauge(measurementsOf(manualRows()))->values.front();
        for (const VarianceComponent& one : once.components) {
            QCOMPARE(again.find(one.component)->interval.upper, one.interval.upper);
            QVERIFY(one.interval.lower <= one.taken && one.taken <= *one.interval.upper);
        }
        QVERIFY(once.distinctCategoriesInterval.lower < *once.distinctCategories);
    }
    void theyHoldTheTruthAsOftenAsTheySay()
    {
        GaugeCoverageOptions options;
        options.runs = coverageRuns();
        options.draws = options.runs > 1000 ? 10'000 : 4000;
        const double margin = countingMargin(options.runs);
        for (const GaugeCoverageRow& row : studyGaugeCoverage(options)) {
            qInfo("%s", qPrintable(coverageText(row)));
            for (const CoveredQuantity q : {CoveredQuantity::Repeatability, CoveredQuantity::Gauge,
                                            CoveredQuantity::Part, CoveredQuantity::Categories})
                QVERIFY2(row.percent(q) > 94 - margin + 1 && row.percent(q) < 96 + margin,
                         qPrintable(coverageText(row)));
            QVERIFY(row.percent(CoveredQuantity::Operator) > 94 - margin);
            QVERIFY(row.percent(CoveredQuantity::PartOperator) > 94 - margin);
        }
    }
    /// Twenty of ninety rows are missing: Satterthwaite's degrees of freedom on projected sums.
    void unbalancedTablesKeepTheirCoverage()
    {
        GaugeCoverageOptions options;
        options.missing = 20;
        options.ratios = {0.3};
        options.draws = 1000;
        options.runs = coverageRuns() > 1000 ? 2000 : 150;
        const double margin = countingMargin(options.runs);
        const GaugeCoverageRow row = studyGaugeCoverage(options).front();
        qInfo("unbalanced, %s", qPrintable(coverageText(row)));
        for (std::size_t q = 0; q < coveredQuantities; ++q)
            QVERIFY2(row.percent(CoveredQuantity(q)) > 93 - margin, qPrintable(coverageText(row)));
    }
    void threadsChangeNothing()
    {
        GaugeCoverageOptions options;
        options.runs = 40;
        options.draws = 500;
        options.ratios = {0.3};
        options.threads = 1;
        const GaugeCoverageRow one = studyGaugeCoverage(options).front();
        options.threads = 3;
        const GaugeCoverageRow three = studyGaugeCoverage(options).front();
        QVERIFY(one.covered == three.covered && one.meanWidth == three.meanWidth);
    }
};

GRIPSCOPE_TEST(GaugeIntervalTest)
#include "gauge_interval_test.moc"
