// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/noise/residual_tests.h"
#include "core/math/decompositions.h"
#include "core/math/gaussian.h"
#include "core/math/sequential_qr.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>

#include <cmath>

using namespace gripscope;

namespace {

std::vector<double> whiteNoise(std::size_t count, std::uint64_t seed)
{
    GaussianNoise noise(seed);
    std::vector<double> e(count);
    for (double& value : e)
        value = noise();
    return e;
}

/// e[t] = r e[t-1] + white.
std::vector<double> correlatedNoise(std::size_t count, double r, std::uint64_t seed)
{
    std::vector<double> e = whiteNoise(count, seed);
    for (std::size_t t = 1; t < count; ++t)
        e[t] += r * e[t - 1];
    return e;
}

/// Orthonormal cosines of 0 to 5 half periods.
Eigen::MatrixXd slowBasis(int count)
{
    Eigen::MatrixXd rows(6, count);
    for (int i = 0; i < 6; ++i) {
        for (int t = 0; t < count; ++t)
            rows(i, t) = std::cos(i * 3.14159265358979 * (t + 0.5) / count);
    }
    return orthonormalize(rows, {}).basis;
}

/// True when `alarms` out of `runs` is what a rate of `rate` gives, but for once in 10,000.
bool isRate(int alarms, int runs, double rate)
{
    const boost::math::binomial distribution(runs, rate);
    return alarms >= boost::math::quantile(distribution, 5e-5) &&
           alarms <= boost::math::quantile(boost::math::complement(distribution, 5e-5));
}

/// p-value of four lagged copies of a white input in a regression on a constant.
std::optional<double> inputP(double coupling, std::uint64_t seed)
{
    const std::vector<double> u = whiteNoise(200, 2 * seed);
    const std::vector<double> e = whiteNoise(200, 2 * seed + 1);
    SequentialQr qr(2 + inputLags.size());
    for (std::size_t t = 0; t < u.size(); ++t) {
        auto row = qr.nextRow();
        row(0) = 1;
        row.segment<inputLags.size()>(1) = laggedInputs(u, t);
        row(1 + inputLags.size()) = e[t] + (t > 0 ? coupling * u[t - 1] : 0);
    }
    return extraColumnsP(qr.triangle(), inputLags.size(), 200);
}

} // namespace

class ResidualTestsTest : public QObject {
    Q_OBJECT
private slots:
    void whiteNoiseAlarmsAtTheStatedRate_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {20, 50, 200, 1000})
            QTest::addRow("%d residuals", count) << count;
    }
    void whiteNoiseAlarmsAtTheStatedRate()
    {
        QFETCH(int, count);
        int alarms = 0;
        constexpr int runs = 2000;
        for (int run = 0; run < runs; ++run)
            alarms += *ljungBoxP(whiteNoise(std::size_t(count), std::uint64_t(run)), 0) < 0.05 ? 1 : 0;
        QVERIFY2(isRate(alarms, runs, 0.05), qPrintable(QString::number(alarms)));
    }
    void residualsOfARegressionAlarmAtTheStatedRate_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("runs");
        for (const auto& [count, runs] : {std::pair(100, 1500), std::pair(400, 1000), std::pair(10000, 150)})
            QTest::addRow("%d residuals", count) << count << runs;
    }
    void residualsOfARegressionAlarmAtTheStatedRate()
    {
        // Six slow regressors, as output error has, take the low frequencies out of the noise.
        QFETCH(int, count);
        QFETCH(int, runs);
        const Eigen::MatrixXd basis = slowBasis(count);
        int alarms = 0;
        for (int run = 0; run < runs; ++run) {
            const std::vector<double> e = whiteNoise(std::size_t(count), std::uint64_t(run) + 7000);
            const Eigen::Map<const Eigen::RowVectorXd> row(e.data(), count);
            const Eigen::RowVectorXd left = row - (row * basis.transpose()) * basis;
            alarms += *ljungBoxP({left.data(), e.size()}, 0, basis) < 0.05 ? 1 : 0;
        }
        QVERIFY2(isRate(alarms, runs, 0.05), qPrintable(QString::number(alarms)));
    }
    void aShareOfSlowNoiseRaisesTheScore()
    {
        const Eigen::MatrixXd basis = slowBasis(1000);
        const std::vector<double> shape{1, 0.9, 0.81, 0.729, 0.656, 0.59};
        double ofWhite = 0;
        double ofSlow = 0;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            ofWhite += *noiseScore(whiteNoise(1000, seed), basis, shape) / 40;
            std::vector<double> e = correlatedNoise(1000, 0.9, seed);
            const std::vector<double> white = whiteNoise(1000, seed + 500);
            for (std::size_t t = 0; t < e.size(); ++t)
                e[t] = 0.2 * e[t] + white[t];
            ofSlow += *noiseScore(e, basis, shape) / 40;
        }
        // The mean of 40 standard normal scores scatters by 0.16; the correction is right to first order.
        QVERIFY(std::abs(ofWhite) < 0.8);
        QVERIFY(ofSlow > 3);
    }
    void regressorsThatExplainNothingAlarmAtTheStatedRate()
    {
        const Eigen::MatrixXd basis = slowBasis(200);
        constexpr int runs = 1000;
        int alarms = 0;
        for (int run = 0; run < runs; ++run) {
            const std::vector<double> u = whiteNoise(200, 2 * std::uint64_t(run));
            const std::vector<double> e = whiteNoise(200, 2 * std::uint64_t(run) + 1);
            const OrthonormalRows extra = orthonormalize(futureInputs(u, 0, 200), basis);
            const auto test =
                testExplained(Eigen::Map<const Eigen::RowVectorXd>(e.data(), 200), basis, extra.basis);
            alarms += test->p < 0.05 ? 1 : 0;
        }
        QVERIFY2(isRate(alarms, runs, 0.05), qPrintable(QString::number(alarms)));
    }
    void pastAndFutureInputStopAtTheRecordsEnds()
    {
        const std::vector<double> u{5, 6, 7, 8};
        const Eigen::MatrixXd past = pastInputs(u, 0, 4);
        QCOMPARE(past(1, 0), 5.0);
        QCOMPARE(past(1, 3), 7.0);
        QCOMPARE(past(7, 3), 5.0);
        const Eigen::MatrixXd future = futureInputs(u, 0, 4);
        QCOMPARE(future(0, 0), 6.0);
        QCOMPARE(future(0, 3), 8.0);
        QCOMPARE(future(3, 0), 8.0);
    }
    void correlatedNoiseIsFound()
    {
        for (std::uint64_t seed = 0; seed < 20; ++seed)
            QVERIFY(*ljungBoxP(correlatedNoise(1000, 0.3, seed), 0) < 1e-4);
    }
    void theScaleOfTheResidualsDoesNotMatter()
    {
        const std::vector<double> e = whiteNoise(200, 3);
        for (const double scale : {1e-200, 1e200}) {
            std::vector<double> scaled = e;
            for (double& value : scaled)
                value *= scale;
            QVERIFY(std::abs(*ljungBoxP(scaled, 0) - *ljungBoxP(e, 0)) < 1e-9);
        }
    }
    void tooFewOrUnchangingResidualsGiveNothing()
    {
        QVERIFY(!ljungBoxP(std::vector<double>{}, 0));
        QVERIFY(!ljungBoxP(std::vector<double>{1, 2, 1, 2}, 0));
        QVERIFY(!ljungBoxP(std::vector<double>(100, 0.0), 0));
        QVERIFY(!ljungBoxP(whiteNoise(8, 1), 3)); // more lags than residuals can answer
    }
    void independentResidualsAlarmAtTheStatedRate()
    {
        int alarms = 0;
        constexpr int runs = 2000;
        for (int run = 0; run < runs; ++run)
            alarms += *inputP(0, std::uint64_t(run)) < 0.05 ? 1 : 0;
        QVERIFY2(isRate(alarms, runs, 0.05), qPrintable(QString::number(alarms)));
    }
    void dependenceOnThePastInputIsFound()
    {
        for (std::uint64_t seed = 0; seed < 20; ++seed)
            QVERIFY(*inputP(0.7, seed) < 1e-4);
    }
    void columnsThatAreNoNewsDoNotCount()
    {
        // The extra column is the model's own: nothing to test.
        SequentialQr qr(3);
        const std::vector<double> e = whiteNoise(100, 9);
        for (std::size_t t = 0; t < 100; ++t) {
            auto row = qr.nextRow();
            row(0) = static_cast<double>(t) + 1;
            row(1) = 3 * (static_cast<double>(t) + 1);
            row(2) = e[t];
        }
        QVERIFY(!extraColumnsP(qr.triangle(), 1, 100));
    }
    void inputBeforeTheRecordIsTheFirstSample()
    {
        const std::vector<double> u{5, 6, 7, 8};
        const auto row = laggedInputs(u, 2);
        QCOMPARE(row(0), 7.0);
        QCOMPARE(row(1), 6.0);
        QCOMPARE(row(2), 5.0);
        QCOMPARE(row(3), 5.0);
    }
    void whiteNoiseDoesNotInflateErrorsCorrelatedNoiseDoes()
    {
        // A constant column and AR(1) residuals: the error of the mean grows by sqrt((1 + r) / (1 - r)), 1.73
        // for r = 0.5. The taper over 50 lags leaves about 2 % of it out, the estimate scatters by about 5 %.
        const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones(5000, 1);
        QVERIFY(std::abs(*errorInflation(constant, correlatedNoise(5000, 0.5, 1)) - 1.73) < 0.35);
        QVERIFY(std::abs(*errorInflation(Eigen::MatrixXd(Eigen::VectorXd::LinSpaced(5000, -1, 1)),
                                         whiteNoise(5000, 2)) -
                         1) < 0.25);
        QVERIFY(!errorInflation(constant, std::vector<double>(5000, 0.0)));
    }
};

GRIPSCOPE_TEST(ResidualTestsTest)
#include "residual_tests_test.moc"
