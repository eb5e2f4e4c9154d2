// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/noise/noise_model.h"
#include "core/math/decompositions.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

/// Stationary e[t] = a1 e[t-1] + a2 e[t-2] + sd w[t].
std::vector<double> autoregressive(std::size_t count, double a1, double a2, double deviation,
                                   std::uint64_t seed)
{
    GaussianNoise noise(seed);
    constexpr std::size_t settle = 500;
    std::vector<double> e(count + settle, 0.0);
    for (std::size_t t = 2; t < e.size(); ++t)
        e[t] = a1 * e[t - 1] + a2 * e[t - 2] + deviation * noise();
    return {e.begin() + settle, e.end()};
}

/// A constant and a slow cosine, orthonormal.
Eigen::MatrixXd driftBasis(int count)
{
    Eigen::MatrixXd rows(2, count);
    for (int t = 0; t < count; ++t)
        rows.col(t) << 1, std::cos(6.283185307179586 * t / count);
    return orthonormalize(rows, {}).basis;
}

} // namespace

class NoiseModelTest : public QObject {
    Q_OBJECT
private slots:
    void coefficientsOfAnAutoregressionAreFound()
    {
        const AutoregressiveNoise noise = fitAutoregressiveNoise(autoregressive(20000, 1.2, -0.5, 3, 1), {});
        QVERIFY(noise.coefficients.size() >= 2);
        // Standard errors: sqrt((1 - a2^2) / N) = 0.006 for both.
        QVERIFY(std::abs(noise.coefficients[0] - 1.2) < 0.03);
        QVERIFY(std::abs(noise.coefficients[1] + 0.5) < 0.03);
        QVERIFY(std::abs(noise.innovationDeviation / 3 - 1) < 0.025);
    }
    void whiteNoiseHasOrderZero()
    {
        // One wrongly chosen order costs ln N: chi-square(1) above ln 400 has 1.4 %, a few orders together 3
        // %.
        int white = 0;
        for (std::uint64_t seed = 0; seed < 100; ++seed)
            white +=
                fitAutoregressiveNoise(autoregressive(400, 0, 0, 1, seed), {}).coefficients.empty() ? 1 : 0;
        QVERIFY2(white >= 90, qPrintable(QString::number(white)));
    }
    void whateverIsGivenAFiniteModelComesOut_data()
    {
        QTest::addColumn<std::vector<double>>("values");
        QTest::newRow("nothing") << std::vector<double>{};
        QTest::newRow("three") << std::vector<double>{1, -2, 1};
        QTest::newRow("constant") << std::vector<double>(50, 4.0);
        QTest::newRow("zeros") << std::vector<double>(50, 0.0);
        QTest::newRow("huge") << autoregressive(100, 0.5, 0, 1e300, 3);
        QTest::newRow("tiny") << autoregressive(100, 0.5, 0, 1e-300, 3);
        std::vector<double> ramp(200);
        for (std::size_t i = 0; i < ramp.size(); ++i)
            ramp[i] = double(i);
        QTest::newRow("ramp") << ramp;
        std::vector<double> flip(200);
        for (std::size_t i = 0; i < flip.size(); ++i)
            flip[i] = i % 2 == 0 ? 1 : -1;
        QTest::newRow("alternating") << flip;
    }
    void whateverIsGivenAFiniteModelComesOut()
    {
        QFETCH(std::vector<double>, values);
        const AutoregressiveNoise noise = fitAutoregressiveNoise(values, {});
        QVERIFY(std::isfinite(noise.innovationDeviation) && noise.innovationDeviation >= 0);
        for (const double a : noise.coefficients)
            QVERIFY(std::isfinite(a));
        for (const double w : whitened(values, noise))
            QVERIFY(std::isfinite(w));
    }
    void whiteningUndoesTheModel()
    {
        AutoregressiveNoise noise;
        noise.coefficients = {1.5, -0.7};
        noise.movingAverage = {-0.4};
        noise.innovationDeviation = 2;
        const std::vector<double> w = autoregressive(100, 0, 0, 2, 5);
        std::vector<double> e(w.size());
        for (std::size_t t = 0; t < w.size(); ++t) {
            e[t] = w[t];
            if (t > 0)
                e[t] += 1.5 * e[t - 1] - 0.4 * w[t - 1];
            if (t > 1)
                e[t] -= 0.7 * e[t - 2];
        }
        const std::vector<double> back = whitened(e, noise);
        for (std::size_t t = 0; t < w.size(); ++t)
            QVERIFY(std::abs(back[t] - w[t]) < 1e-12);
    }
    void theSpreadIsThatOfTheModelsCovariance()
    {
        // AR(1): C[i][j] = s^2 a^|i-j| / (1 - a^2).
        AutoregressiveNoise noise;
        noise.coefficients = {0.8};
        noise.innovationDeviation = 0.5;
        constexpr int count = 60;
        Eigen::MatrixXd c(count, count);
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < count; ++j)
                c(i, j) = 0.25 * std::pow(0.8, std::abs(i - j)) / (1 - 0.64);
        }
        const Eigen::MatrixXd columns = Eigen::MatrixXd::Random(3, count);
        const Eigen::MatrixXd expected = columns * c * columns.transpose();
        QVERIFY((spreadUnderNoise(columns, noise) - expected).norm() < 1e-6 * expected.norm());
    }
    void slopesOfTheSpreadAreItsDifferences()
    {
        AutoregressiveNoise noise;
        noise.coefficients = {1.2, -0.5, 0.1};
        noise.innovationDeviation = 2;
        const Eigen::MatrixXd rows = driftBasis(300);
        const Eigen::MatrixXd slopes = logSpreadSlopes(rows, noise);
        QCOMPARE(slopes.rows(), rows.rows());
        QCOMPARE(slopes.cols(), Eigen::Index(3));
        constexpr double step = 1e-5; // its square is what differences are off by
        for (std::size_t i = 0; i < 3; ++i) {
            AutoregressiveNoise above = noise;
            AutoregressiveNoise below = noise;
            above.coefficients[i] += step;
            below.coefficients[i] -= step;
            const Eigen::ArrayXd up = spreadUnderNoise(rows, above).diagonal();
            const Eigen::ArrayXd down = spreadUnderNoise(rows, below).diagonal();
            const Eigen::VectorXd expected = (up.log() - down.log()) / (2 * step);
            const auto column = static_cast<Eigen::Index>(i);
            QVERIFY((slopes.col(column) - expected).norm() < 1e-6 * expected.norm());
        }
    }
    void whatParametersTakeOutIsPutBack()
    {
        // Residuals after a constant and a slow cosine were fitted: the error of these two, over 300 records.
        const Eigen::MatrixXd basis = driftBasis(200);
        double naive = 0;
        double corrected = 0;
        constexpr int runs = 300;
        for (int run = 0; run < runs; ++run) {
            const std::vector<double> e = autoregressive(200, 0.8, 0, 1, std::uint64_t(run) + 40);
            const Eigen::Map<const Eigen::RowVectorXd> row(e.data(), 200);
            const Eigen::RowVectorXd left = row - (row * basis.transpose()) * basis;
            const std::span<const double> residual(left.data(), 200);
            naive += spreadUnderNoise(basis, fitAutoregressiveNoise(residual, {})).trace() / 2 / runs;
            corrected += spreadUnderNoise(basis, fitAutoregressiveNoise(residual, basis)).trace() / 2 / runs;
        }
        // Truth: about 1 / (1 - 0.8)^2 = 25, less the ends. 300 runs scatter by 3 %.
        AutoregressiveNoise truth;
        truth.coefficients = {0.8};
        truth.innovationDeviation = 1;
        const double expected = spreadUnderNoise(basis, truth).trace() / 2;
        QVERIFY2(std::abs(corrected / expected - 1) < 0.12,
                 qPrintable(QString::number(corrected / expected)));
        QVERIFY2(corrected / naive > 1.05, qPrintable(QString::number(naive / expected)));
    }
};

GRIPSCOPE_TEST(NoiseModelTest)
#include "noise_model_test.moc"
