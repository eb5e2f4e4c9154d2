// SPDX-License-Identifier: GPL-3.0-or-later
// Records with lost samples: the elimination against the whole matrix, and repeated experiments.
#include "core/identification/output_error/output_error.h"
#include "core/identification/output_error/output_error_model.h"
#include "core/identification/output_error/output_error_search.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <Eigen/QR>
#include <QTest>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <array>
#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::Synthetic;

namespace {

/// A true program fails a check of this file once in this many runs of all seeds; the seeds are fixed.
constexpr double lostFalseAlarm = 1e-4;

OutputErrorOptions lostOptions(const Recording& recording)
{
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = recording.hold.value_or(ForceHold::First);
    options.lag_s = recording.forceLag_s;
    return options;
}

void lose(Recording& recording, OutputErrorOptions& options, std::size_t index)
{
    recording.force[index] = recording.position[index] = std::numeric_limits<double>::quiet_NaN();
    options.lost.push_back(index);
}

std::vector<double> response(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                             const std::vector<double>& force, const ScaledNuisance& start)
{
    return simulate({std::exp(theta(0)), std::exp(theta(1)), std::exp(theta(2))}, force,
                    {1, problem.hold, static_cast<double>(problem.lag.samples) + problem.lag.rest, start.x0,
                     start.v0, start.offset});
}

/// Can A with noise of 10 %, autoregressive of the first order, after bursts of lost samples at random.
Estimate afterLosses(double share, std::size_t burst, std::uint64_t seed, double correlation)
{
    Synthetic synthetic;
    synthetic.seed = seed;
    synthetic.x0 = 1;
    synthetic.v0 = -2;
    synthetic.offset = 5;
    Recording recording = synthetic.make();
    GaussianNoise random(seed + 4000);
    constexpr double deviation = 0.5; // about a tenth of the position's
    double e = random();
    for (double& y : recording.position) {
        y += deviation * e;
        e = correlation * e + std::sqrt(1 - correlation * correlation) * random();
    }
    OutputErrorOptions options = lostOptions(recording);
    for (std::size_t t = 0; t < recording.size(); ++t) {
        if (random.uniform() < share / static_cast<double>(burst)) {
            for (std::size_t i = t; i < std::min(t + burst, recording.size()); ++i)
                lose(recording, options, i);
        }
    }
    return estimateOutputError(recording.force, recording.position, options);
}

/// All rows and columns at once: start, offset, every lost force, ln M, ln B, ln K, residual.
Eigen::MatrixXd wholeMatrix(const OutputErrorProblem& problem, const Eigen::Vector3d& theta)
{
    const auto lost = static_cast<Eigen::Index>(problem.lost.size());
    const auto rows = problem.measuredRows();
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows + lost, 3 + lost + 4);
    std::vector<std::ptrdiff_t> index;
    forEachLinearizedRow(problem, theta, unknownNuisance(problem),
                         [&](std::ptrdiff_t t, const Eigen::RowVectorXd& row) {
                             const auto at = static_cast<Eigen::Index>(index.size());
                             all.row(at).head<3>() = row.head<3>();
                             all.row(at).tail<4>() = row.tail<4>();
                             index.push_back(t);
                         });
    for (Eigen::Index j = 0; j < lost; ++j) {
        const auto at = static_cast<std::size_t>(j);
        std::vector<double> force(problem.force.size(), 0.0);
        force[problem.lost[at]] = 1;
        const std::vector<double> x = response(problem, theta, force, {});
        for (std::size_t i = 0; i < index.size(); ++i)
            all(static_cast<Eigen::Index>(i), 3 + j) = x[static_cast<std::size_t>(index[i])];
        all(rows + j, 3 + j) = problem.noiseDeviation / problem.lostForceDeviation[at];
    }
    return all;
}

} // namespace

class OutputErrorLostTest : public QObject {
    Q_OBJECT
private slots:
    void theEliminationIsThatOfTheWholeMatrix_data()
    {
        QTest::addColumn<bool>("straight");
        QTest::addColumn<double>("lag");
        QTest::addColumn<double>("noise");
        for (const bool straight : {false, true}) {
            for (const double lag : {0.0, 0.4, 2.7, -1.3}) {
                for (const double noise : {1e-3, 0.3})
                    QTest::addRow("%s, lag %g samples, noise %g", straight ? "foh" : "zoh", lag, noise)
                        << straight << lag << noise;
            }
        }
    }
    void theEliminationIsThatOfTheWholeMatrix()
    {
        QFETCH(bool, straight);
        QFETCH(double, lag);
        QFETCH(double, noise);
        Synthetic synthetic;
        synthetic.samples = 80;
        synthetic.fitPercent = 90;
        synthetic.x0 = 1;
        synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
        synthetic.lag_s = lag * synthetic.sampleTime_s;
        Recording recording = synthetic.make();
        OutputErrorOptions options = lostOptions(recording);
        for (const std::size_t t : {0U, 1U, 7U, 9U, 20U, 21U, 40U, 41U, 42U, 43U, 60U, 78U, 79U})
            lose(recording, options, t);
        OutputErrorProblem problem = makeOutputErrorProblem(recording.force, recording.position, options);
        problem.noiseDeviation = noise;
        const Eigen::Vector3d theta = problem.toTheta({0.05, 0.1, 0.12});
        ResponseLinearizer linearizer(problem);
        const Linearization got = linearizer.at(theta, unknownNuisance(problem));
        QVERIFY(got.finite);
        QCOMPARE(got.nuisanceRank, 3 + 13);

        const Eigen::MatrixXd all = wholeMatrix(problem, theta);
        const Eigen::Index unknowns = all.cols() - 4;
        const Eigen::MatrixXd linear = all.leftCols(unknowns);
        const Eigen::MatrixXd solution = linear.colPivHouseholderQr().solve(all.rightCols(4));
        const Eigen::MatrixXd rest = all.rightCols(4) - linear * solution;
        const Eigen::Matrix3d information = rest.leftCols(3).transpose() * rest.leftCols(3);
        // Two ways of the same 95 x 20 problem of condition below 1e4.
        constexpr double rounding = 1e-9;
        QVERIFY((got.triangle.transpose() * got.triangle - information).norm() <
                rounding * information.norm());
        QVERIFY((got.triangle.transpose() * got.right - rest.leftCols(3).transpose() * rest.col(3)).norm() <
                rounding * information.norm());
        QVERIFY(std::abs(got.cost / rest.col(3).squaredNorm() - 1) < rounding);
        for (Eigen::Index i = 0; i < 13; ++i) {
            const double expected = problem.force[problem.lost[std::size_t(i)]] + solution(3 + i, 3);
            QVERIFY(std::abs(got.nuisance.lostForces[std::size_t(i)] - expected) < 1e-8);
        }
        QVERIFY((got.nuisanceSlope.bottomRows(13) + solution.block(3, 0, 13, 3)).norm() <
                1e-8 * solution.leftCols(3).norm());
        QVERIFY(std::abs(got.nuisance.x0 - solution(0, 3)) < 1e-8);
        QVERIFY(std::abs(got.nuisance.v0 - solution(1, 3)) < 1e-8);

        // The rows of the tests hold the same problem, the lost forces' columns being gone.
        const OutputErrorRows tested(problem, theta, unknownNuisance(problem));
        const Eigen::MatrixXd start = tested.sensitivities().topRows(3).transpose();
        Eigen::MatrixXd others(tested.residual().size(), 4);
        others << tested.sensitivities().bottomRows(3).transpose(), tested.residual().transpose();
        others -= start * start.colPivHouseholderQr().solve(others);
        QCOMPARE(others.rows(), problem.measuredRows());
        QVERIFY((others.transpose() * others - rest.transpose() * rest).norm() <
                rounding * rest.squaredNorm());
    }

    void withoutNoiseTheTruthComesBackAllTheSame_data()
    {
        QTest::addColumn<bool>("straight");
        QTest::newRow("held") << false;
        QTest::newRow("straight") << true;
    }
    void withoutNoiseTheTruthComesBackAllTheSame()
    {
        QFETCH(bool, straight);
        Synthetic synthetic;
        synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
        synthetic.x0 = 1;
        synthetic.offset = 20;
        Recording recording = synthetic.make();
        OutputErrorOptions options = lostOptions(recording);
        for (std::size_t t = 3; t < 400; t += t % 2 == 0 ? 13 : 20)
            lose(recording, options, t);
        lose(recording, options, 200);
        lose(recording, options, 201);
        const Estimate e = estimateOutputError(recording.force, recording.position, options);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(e.message.describe()));
        QVERIFY2(test::relativeDifference(*e.parameters, synthetic.truth) < 1e-6,
                 qPrintable(QString::number(test::relativeDifference(*e.parameters, synthetic.truth))));
        for (const double value : e.simulated)
            QVERIFY(std::isfinite(value));
        for (const double value : e.residual)
            QVERIFY(std::isfinite(value));
    }

    void lostSamplesCostLittleAndIntervalsCover_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<bool>("straight");
        QTest::addColumn<double>("growth");
        // science.md: a free state for every stretch costs 3 times the error at 5 %, 14 to 26 times at 20 %.
        QTest::newRow("1 %") << 0.01 << false << 1.1;
        QTest::newRow("5 %") << 0.05 << false << 1.25;
        QTest::newRow("20 %") << 0.2 << false << 2.0;
        QTest::newRow("20 %, straight force") << 0.2 << true << 2.0;
    }
    void lostSamplesCostLittleAndIntervalsCover()
    {
        QFETCH(double, share);
        QFETCH(bool, straight);
        QFETCH(double, growth);
        constexpr int runs = 200;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        Eigen::Vector3d grown = Eigen::Vector3d::Zero();
        int covered = 0;
        for (std::uint64_t run = 1; run <= runs; ++run) {
            Synthetic synthetic;
            synthetic.seed = run;
            synthetic.fitPercent = 90;
            synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
            synthetic.x0 = 1;
            synthetic.v0 = -2;
            synthetic.offset = 5;
            Recording recording = synthetic.make();
            OutputErrorOptions options = lostOptions(recording);
            const Estimate whole = estimateOutputError(recording.force, recording.position, options);
            GaussianNoise random(run + 77);
            for (std::size_t t = 0; t < recording.size(); ++t) {
                if (random.uniform() < share)
                    lose(recording, options, t);
            }
            const Estimate e = estimateOutputError(recording.force, recording.position, options);
            QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(e.message.describe()));
            const Eigen::Vector3d z =
                (e.parameters->vector() - synthetic.truth.vector()).cwiseQuotient(*e.standardErrors());
            sum += z;
            squares += z.cwiseAbs2();
            grown += e.standardErrors()->cwiseQuotient(*whole.standardErrors());
            for (Eigen::Index i = 0; i < 3; ++i)
                covered += std::abs(z(i)) < 1.959964 ? 1 : 0;
        }
        // Unbiased: the mean of 200 z scatters by 0.07; 3.9 of that once in 10,000, and a nonlinearity of a
        // tenth of a standard error.
        QVERIFY2((sum / runs).cwiseAbs().maxCoeff() < 0.1 + 3.9 / std::sqrt(double(runs)),
                 qPrintable(QString::number((sum / runs).cwiseAbs().maxCoeff())));
        const boost::math::chi_squared chi(runs);
        const double lowest = 0.9 * boost::math::quantile(chi, lostFalseAlarm);
        const double highest = 1.1 * boost::math::quantile(boost::math::complement(chi, lostFalseAlarm));
        QVERIFY2(squares.minCoeff() > lowest && squares.maxCoeff() < highest,
                 qPrintable(u"%1 to %2"_s.arg(squares.minCoeff() / runs).arg(squares.maxCoeff() / runs)));
        const double missed = 1 - static_cast<double>(covered) / (3.0 * runs);
        const boost::math::binomial misses(runs, 0.05);
        QVERIFY2(missed * runs <= boost::math::quantile(boost::math::complement(misses, lostFalseAlarm)),
                 qPrintable(QString::number(missed)));
        QVERIFY2((grown / runs).maxCoeff() < growth, qPrintable(QString::number((grown / runs).maxCoeff())));
    }

    void theTestsOfResidualsAlarmAtTheirRates_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<std::size_t>("burst");
        QTest::newRow("5 %") << 0.05 << std::size_t(1);
        QTest::newRow("20 %") << 0.2 << std::size_t(1);
        QTest::newRow("bursts of 20") << 0.1 << std::size_t(20);
    }
    void theTestsOfResidualsAlarmAtTheirRates()
    {
        QFETCH(double, share);
        QFETCH(std::size_t, burst);
        constexpr int runs = 200;
        std::array<int, 4> alarms{};
        for (std::uint64_t run = 1; run <= runs; ++run) {
            const Estimate e = afterLosses(share, burst, run, 0);
            QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(e.message.describe()));
            const ResidualSummary& r = e.residuals;
            const std::array<std::optional<double>, 4> p{r.whitenessP, r.inputIndependenceP, r.feedbackP,
                                                         r.linearityP};
            for (std::size_t i = 0; i < p.size(); ++i) {
                QVERIFY(p[i]);
                alarms[i] += *p[i] < 0.05 ? 1 : 0;
            }
        }
        // 2,000 runs each gave 3.6 to 5.4 %.
        const boost::math::binomial law(runs, 0.05);
        for (const int count : alarms)
            QVERIFY2(count <= boost::math::quantile(boost::math::complement(law, lostFalseAlarm)),
                     qPrintable(QString::number(count)));
    }
    void colouredNoiseIsFoundAmongLosses()
    {
        for (std::uint64_t run = 1; run <= 20; ++run) {
            const Estimate e = afterLosses(0.2, 1, run, 0.8);
            QVERIFY(e.residuals.whitenessP && *e.residuals.whitenessP < 1e-4);
            QVERIFY(e.noise);
        }
    }

    void moreThanHalfLostIsTooMuch()
    {
        Recording recording = Synthetic().make();
        OutputErrorOptions options = lostOptions(recording);
        for (std::size_t t = 100; t < 301; ++t)
            lose(recording, options, t);
        const Estimate e = estimateOutputError(recording.force, recording.position, options);
        QCOMPARE(toString(e.status), u"too_few_samples"_s);
        QVERIFY(e.message.describe().contains(u"lost"_s));
    }
    void anyIndexesAreTaken()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 95;
        const Recording recording = synthetic.make();
        OutputErrorOptions options = lostOptions(recording);
        options.lost = {17, 17, 5, 400, 100000};
        const Estimate e = estimateOutputError(recording.force, recording.position, options);
        options.lost = {5, 17};
        const Estimate same = estimateOutputError(recording.force, recording.position, options);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(e.message.describe()));
        QVERIFY(*e.parameters == *same.parameters);
        QCOMPARE(e.residual[5], 0.0);
    }
};

GRIPSCOPE_TEST(OutputErrorLostTest)
#include "output_error_lost_test.moc"
