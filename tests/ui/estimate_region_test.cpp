// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "ui/charts/region_plot.h"
#include "ui/theme/theme.h"

#include <Eigen/LU>
#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

Estimate estimateOf(Estimator estimator, double m, double b, double k)
{
    Estimate estimate;
    estimate.estimator = estimator;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{m, b, k};
    return estimate;
}

/// Output error at (2, 10, 100) with correlated errors of about 1 % and many degrees of freedom.
Identification example(double correlation = -0.6)
{
    Identification identification;
    Estimate best = estimateOf(Estimator::OutputError, 2, 10, 100);
    const Eigen::Vector3d sd{0.02, 0.2, 1};
    Eigen::Matrix3d covariance = sd.asDiagonal() * Eigen::Matrix3d::Identity() * sd.asDiagonal();
    covariance(0, 2) = covariance(2, 0) = correlation * sd[0] * sd[2];
    best.covariance = covariance;
    best.residuals.degreesOfFreedom = 1e9;
    identification.estimates = {best};
    identification.recommended = Estimator::OutputError;
    return identification;
}

} // namespace

class EstimateRegionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void theRegionHasTheJointRadiusOfThreeParameters()
    {
        const auto region = estimateRegion(example());
        QVERIFY(region);
        // Chi-square, 3 degrees of freedom, 95 %: 7.8147; each error is 1, 2, 1 % of its value.
        QVERIFY(std::abs(region->radius * region->radius - 7.8147) < 1e-3);
        QVERIFY(std::abs(region->extent(1) - 2 * std::sqrt(7.8147)) < 1e-3);
        QVERIFY(std::abs(region->correlation(0, 2) + 0.6) < 1e-12);
    }
    void fewSamplesWidenIt()
    {
        Identification few = example();
        few.estimates[0].residuals.degreesOfFreedom = 10;
        // F(3, 10) at 95 %: 3.7083.
        QVERIFY(std::abs(std::pow(estimateRegion(few)->radius, 2) - 3 * 3.7083) < 1e-3);
    }
    void theOutlineIsTheShadowOfTheEllipsoid()
    {
        const auto region = estimateRegion(example());
        const Eigen::Matrix3d information = region->covariance.inverse();
        for (const QPointF& point : region->outline(0, 2)) {
            // Of all points of the ellipsoid above one of the shadow's rim there is just one, on its surface:
            // the least of the quadratic form over the third parameter is the radius squared.
            Eigen::Vector3d at{point.x(), 0, point.y()};
            at[1] = -(information(1, 0) * at[0] + information(1, 2) * at[2]) / information(1, 1);
            QVERIFY(std::abs(at.dot(information * at) / std::pow(region->radius, 2) - 1) < 1e-9);
        }
    }
    void theBudgetsCovarianceTakesThePlaceOfTheOwn()
    {
        const Identification identification = example();
        UncertaintyBudget budget;
        budget.parameters = identification.best()->parameters;
        budget.covariance = 4 * *identification.best()->covariance;
        const auto wide = estimateRegion(identification, budget);
        QVERIFY(std::abs(wide->extent(0) / estimateRegion(identification)->extent(0) - 2) < 1e-6);
        budget.combined[1].degreesOfFreedom = 10; // F(3, 10) at 95 %: 3.7083
        QVERIFY(std::abs(std::pow(estimateRegion(identification, budget)->radius, 2) - 3 * 3.7083) < 1e-3);
    }
    void whatTheEmptyGripperTookMovesNobody()
    {
        Identification identification = example();
        identification.estimates.push_back(estimateOf(Estimator::Arx, 3, 10, 100));
        UncertaintyBudget budget;
        budget.parameters = MassDampingStiffness{1, 9, 90}; // of 2, 10, 100 without the gripper
        budget.covariance = *identification.best()->covariance;
        const auto region = estimateRegion(identification, budget);
        QVERIFY(std::abs(region->others[0].percent[0] - 100) < 1e-9); // 1 more, of 1
        QCOMPARE(region->others[0].percent[1], 0.0);
    }
    void withoutAUsableCovarianceThereIsNone()
    {
        Identification none = example();
        none.estimates[0].covariance.reset();
        QVERIFY(!estimateRegion(none));
        QVERIFY(!estimateRegion(Identification{}));
        QVERIFY(!estimateRegion(example(1)));
        Identification negative = example();
        (*negative.estimates[0].covariance)(1, 1) = -1;
        QVERIFY(!estimateRegion(negative));
    }
    void othersAreToldInPercent()
    {
        Identification identification = example();
        identification.estimates.push_back(estimateOf(Estimator::Arx, 1, 20, 101));
        Estimate failed = estimateOf(Estimator::Arx221, 1, 1, 1);
        failed.status = EstimateStatus::NotConverged;
        identification.estimates.push_back(failed);
        const auto region = estimateRegion(identification);
        QCOMPARE(region->others.size(), std::size_t(1));
        QVERIFY(region->others[0].estimator == Estimator::Arx);
        QVERIFY(std::abs(region->others[0].percent[0] + 50) < 1e-9);
        QVERIFY(std::abs(region->others[0].percent[2] - 1) < 1e-9);
    }
    void theWordsSayWhichErrTogether()
    {
        QVERIFY(correlationWords(*estimateRegion(example(-0.6)))
                    .startsWith(QStringLiteral("m and k err against")));
        QVERIFY(correlationWords(*estimateRegion(example(0.8)))
                    .startsWith(QStringLiteral("m and k err together")));
        QVERIFY(correlationWords(*estimateRegion(example(0.1))).contains(QStringLiteral("independently")));
    }
    void whoIsNearIsInTheFramesAndWhoIsFarIsNot()
    {
        Identification identification = example();
        identification.estimates.push_back(estimateOf(Estimator::Arx221, 2.06, 10.1, 101));
        identification.estimates.push_back(estimateOf(Estimator::Arx, 1, 20, 60));
        RegionPlot plot;
        plot.setRegion(estimateRegion(identification));
        QVERIFY(plot.within(plot.region()->others[0]));
        QVERIFY(!plot.within(plot.region()->others[1]));
        QVERIFY(plot.halfRange(0) < 10); // the far one did not press the ellipse flat
        QVERIFY(plot.accessibleDescription().contains(
            QString::fromUtf8("ARX(2,1,1): m −50 %, b +100 %, k −40 %")));
    }
    void everyAnswerLeavesItsSignInTheFrame()
    {
        Identification identification = example();
        const QColor far = Theme::typeColor(int(Estimator::Arx));
        const auto signPixels = [&] {
            RegionPlot plot;
            plot.resize(420, 360);
            plot.setRegion(estimateRegion(identification));
            const QImage image = plot.grab().toImage();
            int pixels = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    pixels += image.pixelColor(x, y) == far ? 1 : 0;
            return pixels;
        };
        QCOMPARE(signPixels(), 0);
        identification.estimates.push_back(estimateOf(Estimator::Arx, 0.2, 30, 20));
        QVERIFY(signPixels() >= 4 * 12); // three frames and the legend
    }
    void itsNumbersHoldOutlinesAndPoints()
    {
        Identification identification = example();
        identification.estimates.push_back(estimateOf(Estimator::Arx, 1, 20, 60));
        RegionPlot plot;
        QVERIFY(plot.numbers().empty());
        plot.setRegion(estimateRegion(identification));
        const PlotTable table = plot.numbers();
        QCOMPARE(table.size(), std::size_t(7));
        QCOMPARE(table[0].name, QStringLiteral("m-b outline: m (%)"));
        QCOMPARE(table[0].values->front(), table[0].values->back());
        QCOMPARE(table[6].values->size(), std::size_t(3));
    }
    void withoutARegionItSaysSo()
    {
        RegionPlot plot;
        plot.resize(400, 300);
        plot.setRegion(std::nullopt);
        QVERIFY(!plot.grab().isNull());
        QVERIFY(plot.accessibleDescription().isEmpty());
    }
};

GRIPSCOPE_TEST(EstimateRegionTest)
#include "estimate_region_test.moc"
