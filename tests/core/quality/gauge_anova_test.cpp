// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/normal_spread.h"
#include "core/quality/gauge/cell_means.h"
#include "core/quality/gauge/source_sums.h"
#include "tests/core/quality/gauge_tables.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

GaugeValue gaugeValueOf(const std::vector<GaugeRow>& rows, const GaugeOptions& options = {})
{
    return studyGauge(measurementsOf(rows), options).value().values.front();
}

double gaugeVariance(const GaugeValue& value, GaugeComponent component)
{
    return value.find(component)->estimate;
}

/// Sum over rows of (mean of the rows that agree in the chosen factors - what simpler means explain)^2.
double bruteSum(const std::vector<GaugeRow>& rows, bool part, bool operators)
{
    const auto meanWhere = [&](const GaugeRow& like, bool p, bool o) {
        double sum = 0;
        int count = 0;
        for (const GaugeRow& row : rows)
            if ((!p || row.part == like.part) && (!o || row.operators == like.operators)) {
                sum += row.value;
                ++count;
            }
        return sum / count;
    };
    double squares = 0;
    for (const GaugeRow& row : rows) {
        double effect = meanWhere(row, part, operators) - meanWhere(row, false, false);
        if (part && operators)
            effect = meanWhere(row, true, true) - meanWhere(row, true, false) - meanWhere(row, false, true) +
                     meanWhere(row, false, false);
        squares += effect * effect;
    }
    return squares;
}

} // namespace

class GaugeAnovaTest : public QObject {
    Q_OBJECT
private slots:
    void thePublishedCrossedTableComesOut()
    {
        const GaugeValue pooled = gaugeValueOf(prototypeRows());
        const std::array<double, 4> squares{0.60035926, 0.02647037, 0.02084815, 0.02141111};
        for (std::size_t i = 0; i < squares.size(); ++i)
            QVERIFY(isNear(pooled.table[i].meanSquare, squares[i], 5e-9));
        QVERIFY(isNear(*pooled.table[2].f, 0.974, 5e-4));
        QVERIFY(isNear(*pooled.table[2].p, 0.446, 5e-4));
        const VarianceComponent& gauge = *pooled.find(GaugeComponent::Gauge);
        QVERIFY(isNear(gauge.percentContribution, 25.379, 5e-4));
        QVERIFY(isNear(gauge.percentStudyVariation, 50.378, 5e-4));
        QVERIFY(pooled.pooled == std::vector<GaugeSource>{GaugeSource::PartOperator});
    }
    void withoutPoolingANegativeComponentIsSaid()
    {
        GaugeOptions options;
        options.pooling = false;
        const GaugeValue kept = gaugeValueOf(prototypeRows(), options);
        const VarianceComponent& gauge = *kept.find(GaugeComponent::Gauge);
        QVERIFY(isNear(gauge.percentContribution, 25.497, 5e-4));
        QVERIFY(isNear(gauge.percentStudyVariation, 50.494, 5e-4));
        const VarianceComponent& interaction = *kept.find(GaugeComponent::PartOperator);
        QVERIFY(isNear(interaction.estimate, (0.02084815 - 0.02141111) / 3, 1e-8));
        QVERIFY(interaction.taken == 0 && kept.pooled.empty());
        QVERIFY(english(kept.messages).join(u' ').contains(u"is negative (-0.0001877) and is taken as 0"_s));
    }
    /// Ten parts, three appraisers: sums of squares and shares as they are printed everywhere.
    void theManualsTableComesOut()
    {
        const GaugeValue value = gaugeValueOf(manualRows());
        const std::array<double, 4> squares{88.3619, 3.1673, 0.3590, 2.7589};
        for (std::size_t i = 0; i < squares.size(); ++i)
            QVERIFY(isNear(value.table[i].sumOfSquares, squares[i], 5e-5));
        QVERIFY(isNear(gaugeVariance(value, GaugeComponent::Gauge), 0.09143, 5e-6));
        QVERIFY(isNear(gaugeVariance(value, GaugeComponent::Part), 1.08645, 5e-6));
        QVERIFY(isNear(value.find(GaugeComponent::Gauge)->percentContribution, 7.76, 5e-3));
        QCOMPARE(std::floor(*value.distinctCategories), 4.0);
    }
    void nestedGlucoseComesOutBothWays()
    {
        std::vector<GaugeRow> rows = glucoseRows();
        for (const bool daysAreParts : {true, false}) {
            if (!daysAreParts)
                for (GaugeRow& row : rows)
                    std::swap(row.part, row.operators);
            GaugeOptions options;
            options.design = GaugeDesign::Nested;
            const GaugeValue value = gaugeValueOf(rows, options);
            const GaugeComponent day = daysAreParts ? GaugeComponent::Part : GaugeComponent::Operator;
            const GaugeComponent run = daysAreParts ? GaugeComponent::Operator : GaugeComponent::Part;
            QVERIFY(isNear(value.mean, 244.2, 1e-12));
            QVERIFY(isNear(value.table[daysAreParts ? 0 : 1].meanSquare, 21.8842105, 5e-8));
            QVERIFY(isNear(value.table[daysAreParts ? 1 : 0].meanSquare, 14.05, 1e-12));
            QVERIFY(isNear(value.table[2].meanSquare, 7.9, 1e-12));
            QVERIFY(isNear(gaugeVariance(value, day), 1.958553, 5e-7));
            QVERIFY(isNear(gaugeVariance(value, run), 3.075, 1e-12));
            QVERIFY(isNear(gaugeVariance(value, GaugeComponent::Repeatability), 7.9, 1e-12));
        }
    }
    /// (MS interaction - MS repeatability) / trials, where some divide by the parts.
    void theInteractionIsDividedByTheTrials()
    {
        const std::vector<GaugeRow> rows = drawnCrossedRows(10, 2, 0, 2, {3, 1, 0, 1, 0, 0.3}, 4);
        const GaugeValue value = gaugeValueOf(rows);
        const double repeatability = value.table[3].meanSquare;
        QVERIFY(isRelativelyNear(gaugeVariance(value, GaugeComponent::PartOperator),
                                 (value.table[2].meanSquare - repeatability) / 2, 1e-12));
        QVERIFY(isRelativelyNear(gaugeVariance(value, GaugeComponent::Part),
                                 (value.table[0].meanSquare - value.table[2].meanSquare) / 4, 1e-12));
        QVERIFY(isRelativelyNear(value.table[0].sumOfSquares, bruteSum(rows, true, false), 1e-12));
        QVERIFY(isRelativelyNear(value.table[1].sumOfSquares, bruteSum(rows, false, true), 1e-12));
        QVERIFY(isRelativelyNear(value.table[2].sumOfSquares, bruteSum(rows, true, true), 1e-12));
    }
    /// Projections know nothing of balance: on balanced tables both ways give the same.
    void projectionsAgreeWithMeans_data()
    {
        QTest::addColumn<int>("operators");
        QTest::addColumn<int>("stations");
        QTest::addColumn<bool>("nested");
        QTest::newRow("parts alone") << 1 << 0 << false;
        QTest::newRow("crossed") << 3 << 0 << false;
        QTest::newRow("expanded") << 3 << 2 << false;
        QTest::newRow("nested") << 3 << 0 << true;
        QTest::newRow("nested with stations") << 3 << 2 << true;
    }
    void projectionsAgreeWithMeans()
    {
        QFETCH(int, operators);
        QFETCH(int, stations);
        QFETCH(bool, nested);
        std::vector<GaugeRow> rows =
            drawnCrossedRows(5, operators, stations, 2, {2, 1, 0.7, 0.5, 0.4, 0.3}, 9);
        if (nested)
            for (GaugeRow& row : rows)
                row.part += 5 * row.operators;
        GaugeLayout layout = gaugeLayout(factorsOf(rows)).value();
        QVERIFY(layout.balanced && (layout.design == GaugeDesign::Nested) == nested);
        const SourceSums means = sourceSums(layout, valuesOf(rows)).value();
        layout.balanced = false;
        const SourceSums projected = sourceSums(layout, valuesOf(rows)).value();
        QVERIFY(means.sources == projected.sources);
        QVERIFY((means.coefficients - projected.coefficients).cwiseAbs().maxCoeff() < 1e-9);
        QVERIFY((means.degreesOfFreedom - projected.degreesOfFreedom).cwiseAbs().maxCoeff() < 1e-12);
        double sum = 0;
        for (std::size_t s = 0; s < means.products.size(); ++s) {
            QVERIFY(isRelativelyNear(projected.products[s](0, 0), means.products[s](0, 0), 1e-10));
            sum += means.products[s](0, 0);
        }
        QVERIFY(isRelativelyNear(sum, means.total(0, 0), 1e-12));
        // Satterthwaite's degrees of freedom are the exact ones there.
        const Eigen::VectorXd degrees = projected.effectiveDegrees(projected.momentVariances().cwiseMax(0));
        QVERIFY((degrees - means.degreesOfFreedom).cwiseAbs().maxCoeff() < 1e-6);
    }
    /// As NIST's SmLs sets: 9 treatments, 21 values each, F 21 exactly, thirteen constant leading digits.
    void constantLeadingDigitsCostNothing_data()
    {
        QTest::addColumn<double>("constant");
        QTest::addColumn<double>("unit");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("small") << 1.4 << 0.1 << 1e-12;
        QTest::newRow("7 digits") << 1e6 << 0.125 << 1e-12;
        QTest::newRow("13 digits, exact in binary") << 1e12 << 0.125 << 1e-12;
        QTest::newRow("13 digits, decimal") << 1e12 + 0.4 << 0.1 << 4e-3; // 1e12 + 0.4 is held to 6e-5
    }
    void constantLeadingDigitsCostNothing()
    {
        QFETCH(double, constant);
        QFETCH(double, unit);
        QFETCH(double, tolerance);
        std::vector<GaugeRow> rows;
        for (int treatment = 0; treatment < 9; ++treatment)
            for (int i = 0; i < 21; ++i) {
                const int centre = treatment == 0 ? 0 : treatment % 2 == 1 ? -1 : 1;
                const int off = i == 0 ? 0 : i % 2 == 1 ? -1 : 1;
                rows.push_back({treatment, -1, -1, constant + unit * (centre + off)});
            }
        const GaugeValue value = gaugeValueOf(rows);
        QVERIFY2(isRelativelyNear(*value.table[0].f, 21, tolerance),
                 qPrintable(QString::number(*value.table[0].f, 'g', 15)));
        QVERIFY(isRelativelyNear(value.table[0].sumOfSquares, 168 * unit * unit, tolerance));
        QVERIFY(isRelativelyNear(value.table[1].sumOfSquares, 180 * unit * unit, tolerance));
    }
    void rangesHaveTheirConstants()
    {
        QVERIFY(isNear(rangeMoments(2).d2, 2 / std::sqrt(3.14159265358979324), 1e-10));
        QVERIFY(isNear(rangeMoments(3).d2, 3 / std::sqrt(3.14159265358979324), 1e-10));
        QVERIFY(isNear(rangeMoments(5).d2, 2.3259289, 5e-8));
        QVERIFY(isNear(rangeMoments(5).d3, 0.8640819, 5e-8));
        QVERIFY(isNear(rangeMoments(10).d2, 3.0775055, 5e-8));
        const std::array<std::array<double, 3>, 4> tabulated{
            // trials, d2* of one range, degrees of freedom
            {{2, 1.41421, 1.0}, {3, 1.91155, 2.0}, {5, 2.48124, 3.8}, {10, 3.17905, 7.7}}};
        for (const auto& [n, d2Star, degrees] : tabulated) {
            QVERIFY(isNear(meanRange(int(n), 1).d2Star, d2Star, 1.5e-5));
            QVERIFY(isNear(meanRange(int(n), 1).degreesOfFreedom, degrees, 0.06));
        }
    }
    /// The manual rounds d2* to d2 for more than 20 ranges, hence the tolerances.
    void rangesGiveTheManualsFigures()
    {
        GaugeOptions options;
        options.method = GaugeMethod::MeanRange;
        const GaugeValue value = gaugeValueOf(manualRows(), options);
        QVERIFY(
            isRelativelyNear(std::sqrt(gaugeVariance(value, GaugeComponent::Repeatability)), 0.20188, 6e-3));
        QVERIFY(isRelativelyNear(std::sqrt(gaugeVariance(value, GaugeComponent::Operator)), 0.22963, 1e-3));
        QVERIFY(isRelativelyNear(std::sqrt(gaugeVariance(value, GaugeComponent::Gauge)), 0.30575, 3e-3));
        QVERIFY(isRelativelyNear(std::sqrt(gaugeVariance(value, GaugeComponent::Part)), 1.10456, 3e-4));
        QVERIFY(isRelativelyNear(std::sqrt(gaugeVariance(value, GaugeComponent::Total)), 1.14610, 5e-4));
        QVERIFY(value.table.empty());
        options.method = GaugeMethod::MeanRange;
        const auto unbalanced = studyGauge(measurementsOf(thinned(manualRows(), 0.2, 1)), options);
        QVERIFY(!unbalanced && unbalanced.error().code == ErrorCode::Usage);
    }
    void sharesAreOfTheTolerance()
    {
        GaugeMeasurements two = measurementsOf(manualRows());
        two.names = QStringList{u"a"_s, u"b"_s};
        two.values.conservativeResize(Eigen::NoChange, 2);
        two.values.col(1) = 3 * two.values.col(0);
        GaugeOptions options;
        options.tolerances = {8, 12};
        options.studyVariation = 5.15;
        const GaugeStudy study = studyGauge(two, options).value();
        const double deviation = std::sqrt(study.values[0].find(GaugeComponent::Gauge)->taken);
        QVERIFY(isRelativelyNear(*study.values[0].find(GaugeComponent::Gauge)->percentTolerance,
                                 100 * 5.15 * deviation / 8, 1e-12));
        QVERIFY(isRelativelyNear(*study.values[1].find(GaugeComponent::Gauge)->percentTolerance,
                                 100 * 5.15 * 3 * deviation / 12, 1e-12));
    }
};

GRIPSCOPE_TEST(GaugeAnovaTest)
#include "gauge_anova_test.moc"
