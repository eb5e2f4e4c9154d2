// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/cell_means.h"
#include "tests/core/quality/gauge_tables.h"
#include "tests/support/test_registry.h"

#include <Eigen/Dense>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// The restricted likelihood by its textbook form, a row and column a measurement.
double plainLogLikelihood(const GaugeLayout& layout, const Eigen::VectorXd& values,
                          const Eigen::VectorXd& variances)
{
    const Eigen::Index rows = values.size();
    Eigen::MatrixXd v = variances[variances.size() - 1] * Eigen::MatrixXd::Identity(rows, rows);
    for (std::size_t t = 0; t < layout.terms.size(); ++t)
        for (Eigen::Index i = 0; i < rows; ++i)
            for (Eigen::Index j = 0; j < rows; ++j)
                if (layout.terms[t].cell[std::size_t(i)] == layout.terms[t].cell[std::size_t(j)])
                    v(i, j) += variances[Eigen::Index(t)];
    const Eigen::LLT<Eigen::MatrixXd> factor(v);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows);
    const double information = ones.dot(factor.solve(ones));
    const Eigen::VectorXd rest = values - ones * (ones.dot(factor.solve(values)) / information);
    return -(2 * factor.matrixLLT().diagonal().array().log().sum() + std::log(information) +
             rest.dot(factor.solve(rest))) /
           2;
}

/// d l / d log variance: 0 at an optimum.
double logSlope(const GaugeLayout& layout, const Eigen::VectorXd& values, Eigen::VectorXd variances,
                Eigen::Index at)
{
    const double step = 1e-4, start = variances[at];
    variances[at] = start * std::exp(step);
    const double above = plainLogLikelihood(layout, values, variances);
    variances[at] = start * std::exp(-step);
    return (above - plainLogLikelihood(layout, values, variances)) / (2 * step);
}

} // namespace

class GaugeRemlTest : public QObject {
    Q_OBJECT
private slots:
    void balancedTablesGiveTheMethodOfMoments_data()
    {
        QTest::addColumn<int>("stations");
        QTest::addColumn<bool>("nested");
        QTest::newRow("crossed") << 0 << false;
        QTest::newRow("nested") << 0 << true;
        QTest::newRow("expanded") << 3 << false;
    }
    void balancedTablesGiveTheMethodOfMoments()
    {
        QFETCH(int, stations);
        QFETCH(bool, nested);
        int compared = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            std::vector<GaugeRow> rows =
                drawnCrossedRows(6, 4, stations, 2, {2, 1.5, 1.2, 0.8, 0.7, 0.3}, seed);
            if (nested)
                for (GaugeRow& row : rows)
                    row.part += 100 * row.operators;
            GaugeLayout layout = gaugeLayout(factorsOf(rows)).value();
            const Eigen::VectorXd values = valuesOf(rows);
            const Eigen::VectorXd moments = sourceSums(layout, values)->momentVariances();
            if (moments.minCoeff() < 0)
                continue;
            const RestrictedLikelihoodResult found = restrictedLikelihood(layout, values);
            QVERIFY(found.converged);
            for (Eigen::Index l = 0; l < moments.size(); ++l)
                QVERIFY2(isRelativelyNear(found.variances[l], moments[l], 1e-6),
                         qPrintable(u"%1 %2 %3"_s.arg(seed).arg(found.variances[l]).arg(moments[l])));
            ++compared;
        }
        QVERIFY(compared >= 10);
    }
    /// The interaction would be negative: at the boundary the rest is what pooling gives.
    void negativeComponentsEndAtTheBoundary()
    {
        GaugeLayout layout = gaugeLayout(factorsOf(prototypeRows())).value();
        const Eigen::VectorXd values = valuesOf(prototypeRows());
        const RestrictedLikelihoodResult found = restrictedLikelihood(layout, values);
        QVERIFY(found.boundary == std::vector<bool>({false, false, true, false}));
        QCOMPARE(found.variances[2], 0.0);
        GaugeLayout pooled = layout.without(GaugeSource::PartOperator);
        const Eigen::VectorXd moments = sourceSums(pooled, values)->momentVariances();
        QVERIFY(isRelativelyNear(found.variances[0], moments[0], 1e-6));
        QVERIFY(isRelativelyNear(found.variances[1], moments[1], 1e-6));
        QVERIFY(isRelativelyNear(found.variances[3], moments[2], 1e-6));
        GaugeOptions options;
        options.method = GaugeMethod::Reml;
        options.pooling = false;
        const GaugeStudy study = studyGauge(measurementsOf(prototypeRows()), options).value();
        QVERIFY(english(study.values.front().messages).join(u' ').contains(u"estimated as 0"_s));
    }
    void unbalancedTablesEndAtTheMaximum()
    {
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const int stations = seed % 3 == 0 ? 2 : 0;
            const std::vector<GaugeRow> rows =
                thinned(drawnCrossedRows(6, 3, stations, 3, {2, 0.8, 0.5, 0.6, 0.3, 1}, seed), 0.4, seed);
            GaugeLayout layout = gaugeLayout(factorsOf(rows)).value();
            QVERIFY(!layout.balanced);
            const Eigen::VectorXd values = valuesOf(rows);
            const RestrictedLikelihoodResult found = restrictedLikelihood(layout, values);
            QVERIFY(found.converged);
            QVERIFY(isNear(found.logLikelihood - plainLogLikelihood(layout, values, found.variances),
                           restrictedLikelihood(layout, 3 * values).logLikelihood -
                               plainLogLikelihood(layout, 3 * values, 9 * found.variances),
                           1e-7)); // the same constant
            for (Eigen::Index l = 0; l < found.variances.size(); ++l) {
                if (found.boundary[std::size_t(l)]) {
                    Eigen::VectorXd inside = found.variances;
                    inside[l] = 1e-4;
                    QVERIFY(plainLogLikelihood(layout, values, inside) <=
                            plainLogLikelihood(layout, values, found.variances) + 1e-9);
                } else {
                    QVERIFY2(std::abs(logSlope(layout, values, found.variances, l)) < 1e-6,
                             qPrintable(u"%1 %2"_s.arg(seed).arg(l)));
                }
            }
        }
    }
    /// Small tables of few digits, where scoring alone creeps.
    void smallCoarseTablesConverge()
    {
        int iterations = 0;
        for (std::uint64_t seed = 1; seed <= 300; ++seed) {
            RandomStream random(seed, 1, 1);
            std::vector<GaugeRow> rows;
            for (int i = 0; i < 24; ++i)
                rows.push_back({int(4 * random.uniform()), int(3 * random.uniform()), -1,
                                std::floor(3 * random.uniform())});
            const GaugeLayout layout = gaugeLayout(factorsOf(rows), GaugeDesign::Crossed).value();
            const RestrictedLikelihoodResult found = restrictedLikelihood(layout, valuesOf(rows));
            QVERIFY2(found.converged, qPrintable(QString::number(seed)));
            iterations = std::max(iterations, found.iterations);
        }
        QVERIFY2(iterations <= 60, qPrintable(QString::number(iterations)));
    }
    /// A constant, a unit and the order of the rows change nothing.
    void unitsAndOrderDoNotMatter()
    {
        std::vector<GaugeRow> rows = thinned(drawnCrossedRows(6, 3, 0, 3, {2, 0.8, 0, 0.6, 0, 1}, 4), 0.3, 4);
        const GaugeLayout layout = gaugeLayout(factorsOf(rows)).value();
        const Eigen::VectorXd found = restrictedLikelihood(layout, valuesOf(rows)).variances;
        std::reverse(rows.begin(), rows.end());
        for (GaugeRow& row : rows)
            row.value = 1e-6 * (row.value + 1e6);
        const GaugeLayout turned = gaugeLayout(factorsOf(rows)).value();
        const Eigen::VectorXd again = restrictedLikelihood(turned, valuesOf(rows)).variances;
        for (Eigen::Index l = 0; l < found.size(); ++l)
            QVERIFY(isRelativelyNear(again[l] * 1e12, found[l], 1e-6));
    }
};

GRIPSCOPE_TEST(GaugeRemlTest)
#include "gauge_reml_test.moc"
