// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/recognition/early/linearized_evidence.h"
#include "tests/support/test_registry.h"

#include <Eigen/Dense>
#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

constexpr Eigen::Index rows = 40, nuisances = 2, columns = nuisances + 4;

Eigen::MatrixXd randomRows()
{
    GaussianNoise noise(3);
    Eigen::MatrixXd matrix(rows, columns);
    for (Eigen::Index t = 0; t < rows; ++t)
        for (Eigen::Index j = 0; j < columns; ++j)
            matrix(t, j) = noise();
    return matrix;
}

LaggedProducts productsOf(const Eigen::MatrixXd& matrix, Eigen::Index gapAfter = rows)
{
    LaggedProducts products(matrix.cols());
    for (Eigen::Index t = 0; t < matrix.rows(); ++t)
        products.add(t < gapAfter ? t : t + 5, matrix.row(t));
    return products;
}

/// Covariance of autoregressive noise driven by unit variance, independent across the gap.
Eigen::MatrixXd noiseCovariance(double pole, Eigen::Index gapAfter = rows)
{
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(rows, rows);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index j = 0; j < rows; ++j)
            if ((i < gapAfter) == (j < gapAfter))
                covariance(i, j) = std::pow(pole, std::abs(i - j)) / (1 - pole * pole);
    return covariance;
}

} // namespace

class LinearizedEvidenceTest : public QObject {
    Q_OBJECT

private slots:
    void lagProductsGiveTheNormalMatrixOfEveryPole_data()
    {
        QTest::addColumn<double>("pole");
        QTest::addColumn<int>("gapAfter");
        for (const double pole : {-0.4, 0.0, 0.8, 0.95})
            for (const int gap : {static_cast<int>(rows), 17, 1})
                QTest::addRow("pole %.2f, gap %d", pole, gap) << pole << gap;
    }
    void lagProductsGiveTheNormalMatrixOfEveryPole()
    {
        QFETCH(double, pole);
        QFETCH(int, gapAfter);
        const Eigen::MatrixXd matrix = randomRows();
        const Eigen::MatrixXd expected =
            matrix.transpose() * noiseCovariance(pole, gapAfter).llt().solve(matrix);
        const Eigen::MatrixXd found = productsOf(matrix, gapAfter).whitened(pole);
        QVERIFY((found - expected).norm() < 1e-12 * expected.norm());
    }

    void evidenceIsTheGaussianDensityOfTheRecord_data()
    {
        QTest::addColumn<double>("pole");
        QTest::addColumn<double>("deviation");
        for (const double pole : {0.0, 0.7})
            for (const double deviation : {0.3, 2.0})
                QTest::addRow("pole %.1f, deviation %.1f", pole, deviation) << pole << deviation;
    }
    /// Against the n x n covariance of everything at once: noise, nuisances of variance d^2 / ridge, m, b, k.
    void evidenceIsTheGaussianDensityOfTheRecord()
    {
        QFETCH(double, pole);
        QFETCH(double, deviation);
        constexpr double ridge = 0.02;
        LogPrior prior;
        prior.shift << 0.2, -0.1, 0.4;
        prior.covariance << 0.5, 0.1, 0, 0.1, 0.3, 0.05, 0, 0.05, 0.2;
        const Eigen::MatrixXd matrix = randomRows();
        const auto density = [&](double p, double d) {
            const Eigen::MatrixXd free = matrix.leftCols(nuisances);
            const Eigen::MatrixXd sensitivities = matrix.middleCols(nuisances, 3);
            const Eigen::MatrixXd covariance = d * d * noiseCovariance(p) +

                                               d * d / ridge * free * free.transpose() +
                                               sensitivities * prior.covariance * sensitivities.transpose();
            const Eigen::VectorXd residual = matrix.col(columns - 1) - sensitivities * prior.shift;
            const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
            const Eigen::MatrixXd triangle = factor.matrixL();
            // The evidence is flat in the nuisances: their prior's width does not grow with d.
            return -triangle.diagonal().array().log().sum() - residual.dot(factor.solve(residual)) / 2 +
                   nuisances * std::log(d);
        };
        const std::vector<NoiseNode> nodes{{0.0, {1.0}}, {pole, {deviation}}};
        const LinearizedEvidence evidence = linearizedEvidence(productsOf(matrix), prior, nodes, ridge);
        const double found = evidence.log[1] - evidence.log[0];
        const double expected = density(pole, deviation) - density(0.0, 1.0);
        QVERIFY2(std::abs(found - expected) < 1e-9 * std::abs(expected),
                 qPrintable(QStringLiteral("%1, expected %2").arg(found).arg(expected)));
    }

    void theStepIsTheLikeliestOne()
    {
        Eigen::MatrixXd matrix = randomRows();
        const Eigen::Vector3d truth(0.3, -0.2, 0.1);
        matrix.col(columns - 1) = matrix.middleCols(nuisances, 3) * truth + 5 * matrix.col(0);
        const std::vector<NoiseNode> nodes{{0.0, {1e-4}}};
        const LogPrior wide{Eigen::Vector3d::Zero(), 100 * Eigen::Matrix3d::Identity()};
        const LinearizedEvidence evidence = linearizedEvidence(productsOf(matrix), wide, nodes, 1e-12);
        QVERIFY((evidence.step - truth).norm() < 1e-6);
    }
};

GRIPSCOPE_TEST(LinearizedEvidenceTest)
#include "linearized_evidence_test.moc"
