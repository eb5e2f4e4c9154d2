// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/types/type_model.h"
#include "tests/core/recognition/gaussian_types.h"
#include "tests/support/test_registry.h"

#include <Eigen/Eigenvalues>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class TypeModelTest : public QObject {
    Q_OBJECT
private slots:
    void modelsAreMeansAndPooledCovarianceOfTheLogs()
    {
        const std::vector<TypeSqueeze> squeezes = {{u"B"_s, {std::exp(1.0), std::exp(2.0), std::exp(3.0)}},
                                                   {u"A"_s, {std::exp(0.0), std::exp(0.0), std::exp(0.0)}},
                                                   {u"A"_s, {std::exp(2.0), std::exp(2.0), std::exp(-2.0)}},
                                                   {u"B"_s, {std::exp(1.0), std::exp(4.0), std::exp(3.0)}}};
        const TypeModels models = fitTypeModels(squeezes);
        QCOMPARE(models.types.size(), std::size_t(2));
        QCOMPARE(models.types[0].name, u"A"_s);
        QCOMPARE(models.types[0].squeezes, 2);
        QCOMPARE(models.degreesOfFreedom, 2);
        QVERIFY((models.types[0].meanLog - Eigen::Vector3d(1, 1, -1)).norm() < 1e-14);
        QVERIFY((models.find(u"B"_s)->meanLog - Eigen::Vector3d(1, 3, 3)).norm() < 1e-14);
        QVERIFY(!models.find(u"C"_s));
        // Sums over both types: 2 (1, 1, -1)(1, 1, -1)' + 2 (0, 1, 0)(0, 1, 0)', over v = 2, then w = 1/9.
        Eigen::Matrix3d wanted;
        const double c = 8.0 / 9;
        wanted << 1, c, -c, c, 2, -c, -c, -c, 1;
        QCOMPARE(models.shrinkage, 1.0 / 9);
        QVERIFY((models.covarianceLog - wanted).norm() < 1e-14);
    }
    void theAppendixHasTheOraclesPooledCovarianceNearly()
    {
        // To first order cov(log x) = cov(x) / (mean x)^2 within a type; scatter of 5 % leaves about 5 %
        // between them.
        const TypeModels models = fitTypeModels(paperSqueezesAsPrinted());
        QCOMPARE(models.degreesOfFreedom, 36);
        for (int i = 0; i < 3; ++i) {
            double linear = 0;
            for (int type = 0; type < 4; ++type) {
                const Eigen::VectorXd x = paperAppendix().parameters.col(i).segment(10 * type, 10);
                linear += (x.array() - x.mean()).square().sum() / 9 / (x.mean() * x.mean()) / 4;
            }
            QVERIFY(std::abs(models.covarianceLog(i, i) / linear - 1) < 0.05);
        }
    }
    void scalingTheUnitsChangesNoDistance()
    {
        const TypeModels printed = fitTypeModels(paperSqueezesAsPrinted());
        const TypeModels si = fitTypeModels(paperSqueezesInSi());
        for (std::size_t i = 0; i < 40; ++i) {
            const double a =
                *squaredDistance(printed, printed.types[1], paperSqueezesAsPrinted()[i].parameters);
            const double b = *squaredDistance(si, si.types[1], paperSqueezesInSi()[i].parameters);
            QVERIFY(std::abs(a / b - 1) < 1e-9); // condition of S about 1e2, logs of size 10
        }
    }
    void shrinkageGoesToZeroAndKeepsFewSqueezesUsable()
    {
        GaussianTypes source(1, 0.9);
        double last = 1;
        for (int squeezes : {2, 3, 5, 10, 100}) {
            const TypeModels models = fitTypeModels(source.enrolment(1, squeezes));
            QVERIFY(models.shrinkage < last);
            last = models.shrinkage;
            QCOMPARE(models.covarianceLog.llt().info(), Eigen::Success);
            QVERIFY(*squaredDistance(models, models.types[0], source.squeeze(0)) >= 0);
        }
        QVERIFY(last < 2e-6);
    }
    void copiesOfOneSqueezeGiveAFiniteDistance()
    {
        const TypeModels models = fitTypeModels(std::vector<TypeSqueeze>(5, {u"A"_s, {1, 2, 3}}));
        const double own = *squaredDistance(models, models.types[0], {1, 2, 3});
        const double off =
            *squaredDistance(models, models.types[0], {1.001, 2, 3}); // ten times the least scatter
        QVERIFY(own < 1e-12);
        QVERIFY(std::abs(off - 100) < 0.2); // log 1.001 is 0.9995e-3
    }
    void parametersThatGoExactlyTogetherGiveAFiniteDistance()
    {
        std::vector<TypeSqueeze> squeezes;
        for (int i = 0; i < 20'000; ++i)
            squeezes.push_back({u"A"_s, {1.0 + i % 7, 1.0 + i % 7, 1.0 + i % 7}});
        const TypeModels models = fitTypeModels(squeezes);
        QVERIFY(*squaredDistance(models, models.types[0], {4, 4, 4}) < 1);
        const double off = *squaredDistance(models, models.types[0], {4, 4, 4.1});
        QVERIFY(std::isfinite(off) && off > 1e6);
    }
    void squeezesThatAreNotPositiveAreLeftOut()
    {
        const TypeModels models = fitTypeModels(
            {{u"A"_s, {1, 2, 3}}, {u"A"_s, {-1, 2, 3}}, {u"A"_s, {1, 0, 3}}, {u"B"_s, {1, 2, std::nan("")}}});
        QCOMPARE(models.types.size(), std::size_t(1));
        QCOMPARE(models.types[0].squeezes, 1);
        QVERIFY(fitTypeModels({}).types.empty());
        QVERIFY(!squaredDistance(models, models.types[0], {1, 2, 3})); // v = 0
        const TypeModels appendix = fitTypeModels(paperSqueezesInSi());
        QVERIFY(!squaredDistance(appendix, appendix.types[0], {1, 2, -3}));
    }
    void gateIsTheFormula_data()
    {
        QTest::addColumn<int>("squeezes");
        QTest::addColumn<int>("types");
        QTest::addColumn<double>("deviations");
        // Reach in standard deviations as computed elsewhere for four types at 1 %.
        QTest::newRow("3 squeezes") << 3 << 4 << 7.2;
        QTest::newRow("5 squeezes") << 5 << 4 << 4.8;
        QTest::newRow("10 squeezes") << 10 << 4 << 3.9;
    }
    void gateIsTheFormula()
    {
        QFETCH(int, squeezes);
        QFETCH(int, types);
        QFETCH(double, deviations);
        const auto gate = falseRejectGate(squeezes, types * (squeezes - 1), 0.01);
        QVERIFY(std::abs(std::sqrt(*gate) - deviations) < 0.05);
    }
    void gateNeedsThreeDegreesOfFreedom()
    {
        QVERIFY(!falseRejectGate(3, 2, 0.01));
        QVERIFY(falseRejectGate(4, 3, 0.01));
        QVERIFY(!falseRejectGate(0, 30, 0.01));
        QVERIFY(!falseRejectGate(4, 30, 0));
        QVERIFY(!falseRejectGate(4, 30, 1));
        QVERIFY(!falseRejectGate(4, 3, 1e-300)); // beyond the largest number: no gate, no exception
    }
    void typeEllipsoidHoldsItsShareOfSqueezes()
    {
        GaussianTypes source(5, 0.5, 0.02);
        const TypeModels models = fitTypeModels(source.enrolment(1, 4000));
        const Ellipsoid ellipsoid = *typeEllipsoid(models, models.types[0], 0.95);
        QVERIFY((ellipsoid.axes.transpose() * ellipsoid.axes - Eigen::Matrix3d::Identity()).norm() < 1e-12);
        int inside = 0;
        constexpr int squeezes = 20000;
        for (int i = 0; i < squeezes; ++i) {
            const Eigen::Vector3d d = source.squeeze(0).vector() - ellipsoid.centre;
            inside += (ellipsoid.axes.transpose() * d).cwiseQuotient(ellipsoid.radii).norm() <= 1;
        }
        // 0.0046 is 3 sd of the binomial; 0.003 for the 4,000 squeezes behind S and the first order in 2 %
        // scatter.
        QVERIFY(std::abs(double(inside) / squeezes - 0.95) < 0.0076);
    }
    void estimateEllipsoidHasTheCovariancesAxes()
    {
        Eigen::Matrix3d covariance;
        covariance << 4, 0, 0, 0, 9, 0, 0, 0, 1;
        const Ellipsoid ellipsoid = *estimateEllipsoid({1, 2, 3}, covariance, 0.95);
        QVERIFY(ellipsoid.centre == Eigen::Vector3d(1, 2, 3));
        // Chi-square, 3 degrees of freedom, 95 %: 7.814728 (tables).
        QVERIFY((ellipsoid.radii - std::sqrt(7.814728) * Eigen::Vector3d(3, 2, 1)).norm() < 1e-5);
        QVERIFY(std::abs(std::abs(ellipsoid.axes(1, 0)) - 1) < 1e-12);
    }
    void anEllipsoidKeepsItsDigitsInSi()
    {
        // Deviations of can A: 1e-4 kg, 0.5 N s/m, 10 N/m, strongly correlated: variances 1e10 apart.
        const Eigen::Vector3d deviations(1e-4, 0.5, 10);
        Eigen::Matrix3d correlation;
        correlation << 1, 0.5, 0.9, 0.5, 1, 0.3, 0.9, 0.3, 1;
        const Eigen::Matrix3d covariance = deviations.asDiagonal() * correlation * deviations.asDiagonal();
        const Ellipsoid e = *estimateEllipsoid({0.04, 43, 9990}, covariance, 0.95);
        const Eigen::Matrix3d back =
            e.axes * e.radii.cwiseAbs2().asDiagonal() * e.axes.transpose() / 7.814727903251;
        for (int i = 0; i < 3; ++i)
            QVERIFY(std::abs(back(i, i) / covariance(i, i) - 1) < 1e-6);
        QVERIFY(std::abs(back.determinant() / covariance.determinant() - 1) < 1e-4);
    }
    void noEllipsoidWithoutACovariance()
    {
        const TypeModels single = fitTypeModels({{u"A"_s, {1, 2, 3}}});
        QVERIFY(!typeEllipsoid(single, single.types[0], 0.95));
        QVERIFY(!estimateEllipsoid({1, 2, 3}, Eigen::Matrix3d::Constant(std::nan("")), 0.95));
        QVERIFY(!estimateEllipsoid({1, 2, 3}, -Eigen::Matrix3d::Identity(), 0.95));
        QVERIFY(!estimateEllipsoid({1, 2, 3}, Eigen::Matrix3d::Identity(), 1));
    }
};

GRIPSCOPE_TEST(TypeModelTest)
#include "type_model_test.moc"
