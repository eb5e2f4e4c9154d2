// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_agreement.h"
#include "core/clustering/gaussian_mixture.h"
#include "core/clustering/kmeans.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/paper_appendix.h"
#include "tests/support/test_registry.h"

#include <Eigen/Cholesky>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;
using namespace Qt::StringLiterals;

Q_DECLARE_METATYPE(gripscope::MixtureCovariance)

namespace {

struct Labelled {
    Eigen::MatrixXd items;
    QStringList truth;
};

/// Two long, thin clouds side by side, in turns.
Labelled twoNeedles(int items)
{
    GaussianNoise noise(11);
    Labelled needles{Eigen::MatrixXd(items, 2), {}};
    for (int i = 0; i < items; ++i) {
        needles.items.row(i) << 8 * noise(), 0.5 * noise() + (i % 2 == 0 ? 0 : 4);
        needles.truth << QString::number(i % 2);
    }
    return needles;
}

double agreement(const Labelled& table, const std::vector<int>& labels)
{
    return clusterAgreement(table.truth, labels, 2).adjustedRandIndex;
}

bool allPositiveDefinite(const MixtureParameters& parameters)
{
    for (const Eigen::MatrixXd& covariance : parameters.covariances)
        if (!covariance.allFinite() || Eigen::LLT<Eigen::MatrixXd>(covariance).info() != Eigen::Success)
            return false;
    return true;
}

} // namespace

class GaussianMixtureTest : public QObject {
    Q_OBJECT
private slots:
    void thePapersFourTypesArePure_data()
    {
        QTest::addColumn<MixtureCovariance>("covariance");
        QTest::newRow("tied") << MixtureCovariance::Tied;
        QTest::newRow("full") << MixtureCovariance::Full;
    }
    void thePapersFourTypesArePure()
    {
        QFETCH(MixtureCovariance, covariance);
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            GaussianMixtureOptions options;
            options.covariance = covariance;
            options.seed = seed;
            const auto found = gaussianMixture(paperAppendix().parameters, options);
            QVERIFY(found->status == MixtureStatus::Converged);
            QCOMPARE(clusterAgreement(paperAppendix().object, found->labels, 4).adjustedRandIndex, 1.0);
            for (int c = 0; c < 4; ++c)
                QCOMPARE(found->labels[std::size_t(10 * c)], c);
        }
    }
    void oneComponentIsTheGaussianOfTheTable()
    {
        const Eigen::MatrixXd& items = paperAppendix().parameters;
        const double n = 40;
        const Eigen::MatrixXd away = items.rowwise() - items.colwise().mean();
        const Eigen::Matrix3d scatter = away.transpose() * away;
        // Four imaginary items with the table's own covariance, and a millionth of the variances on top.
        Eigen::Matrix3d covariance = scatter / n;
        covariance.diagonal() += 4 / (n + 4) * 1e-6 * (scatter / n).diagonal();
        const double logLikelihood =
            -n / 2 * (3 * std::log(2 * std::numbers::pi) + std::log(covariance.determinant())) -
            (covariance.inverse() * scatter).trace() / 2;
        for (const MixtureCovariance kind : {MixtureCovariance::Tied, MixtureCovariance::Full}) {
            GaussianMixtureOptions options;
            options.components = 1;
            options.covariance = kind;
            const auto found = gaussianMixture(items, options);
            // Rounding of numbers near 1, of a covariance with a condition of some ten: far below 1e-10.
            QVERIFY(std::abs(found->logLikelihood - logLikelihood) < 1e-10 * std::abs(logLikelihood));
            QVERIFY((found->parameters.covariances[0] - covariance).norm() < 1e-10 * covariance.norm());
            QVERIFY((found->parameters.means.row(0) - items.colwise().mean()).norm() < 1e-13);
            QCOMPARE(found->parameters.weights(0), 1.0);
            QCOMPARE(found->freeParameters, 9); // three means, six (co)variances
            QVERIFY(std::abs(found->bic - (-2 * logLikelihood + 9 * std::log(n))) < 1e-7);
        }
    }
    void knownParametersAreFound()
    {
        // 30 % around -3, standard deviation 1, and 70 % around 3, standard deviation 0.5: no overlap, so
        // that the errors are those of the separate samples.
        const int n = 20'000;
        GaussianNoise noise(5);
        Eigen::MatrixXd items(n, 1);
        for (int i = 0; i < n; ++i)
            items(i, 0) = noise.uniform() < 0.3 ? noise() - 3 : 0.5 * noise() + 3;
        GaussianMixtureOptions options;
        options.components = 2;
        const auto found = gaussianMixture(items, options);
        const int low = found->parameters.means(0, 0) < 0 ? 0 : 1;
        const double count = 0.3 * n;
        // Five standard errors.
        QVERIFY(std::abs(found->parameters.weights(low) - 0.3) < 5 * std::sqrt(0.3 * 0.7 / n));
        QVERIFY(std::abs(found->parameters.means(low, 0) + 3) < 5 * 1 / std::sqrt(count));
        QVERIFY(std::abs(found->parameters.means(1 - low, 0) - 3) < 5 * 0.5 / std::sqrt(n - count));
        QVERIFY(std::abs(std::sqrt(found->parameters.covariances[std::size_t(low)](0, 0)) - 1) <
                5 * 1 / std::sqrt(2 * count));
    }
    void longThinCloudsAreToldApartWhereKMeansCutsThemAcross()
    {
        const Labelled needles = twoNeedles(400);
        KMeansOptions kmeans;
        kmeans.clusters = 2;
        QVERIFY(agreement(needles, kMeans(needles.items, kmeans)->labels) < 0.2);
        for (const MixtureCovariance kind : {MixtureCovariance::Tied, MixtureCovariance::Full}) {
            GaussianMixtureOptions options;
            options.components = 2;
            options.covariance = kind;
            // Eight deviations apart: hardly one item of a hundred is on the wrong side.
            QVERIFY(agreement(needles, gaussianMixture(needles.items, options)->labels) > 0.96);
        }
    }
    void theObjectiveNeverFalls()
    {
        const Labelled needles = twoNeedles(200);
        for (const MixtureCovariance kind : {MixtureCovariance::Tied, MixtureCovariance::Full})
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                GaussianMixtureOptions options;
                options.components = 5; // more than there are: some components fight for items
                options.covariance = kind;
                options.seed = seed;
                const auto found = gaussianMixture(needles.items, options);
                QCOMPARE(int(found->steps.size()), found->iterations + 1);
                for (std::size_t s = 1; s < found->steps.size(); ++s)
                    // Sums of 200 numbers near 5.
                    QVERIFY(found->steps[s].objective >= found->steps[s - 1].objective - 1e-10);
                QCOMPARE(found->steps.back().labels, found->labels);
                QCOMPARE(found->steps.back().logLikelihood, found->logLikelihood);
                QVERIFY(found->steps.back().parameters.means == found->parameters.means);
            }
    }
    void unitsMakeNoDifference()
    {
        const Eigen::MatrixXd& items = paperAppendix().parameters;
        const Eigen::RowVector3d units(1e-6, 1, 1e6);
        const auto one = gaussianMixture(items);
        const auto other = gaussianMixture(items.array().rowwise() * units.array());
        QCOMPARE(one->labels, other->labels);
        QCOMPARE(one->iterations, other->iterations);
        // The density is one over the units.
        const double shift = 40 * std::log(units.prod());
        QVERIFY(std::abs(other->logLikelihood + shift - one->logLikelihood) < 1e-8);
        for (int c = 0; c < 4; ++c)
            QVERIFY(
                (other->parameters.means.row(c).cwiseQuotient(units) - one->parameters.means.row(c)).norm() <
                1e-9);
    }
    void probabilitiesAddUpToOneAndTheLargestIsTheLabel()
    {
        const Labelled needles = twoNeedles(100);
        GaussianMixtureOptions options;
        options.components = 3;
        const auto found = gaussianMixture(needles.items, options);
        QVERIFY(std::abs(found->parameters.weights.sum() - 1) < 1e-12);
        for (Eigen::Index i = 0; i < found->probabilities.rows(); ++i) {
            Eigen::Index largest = 0;
            found->probabilities.row(i).maxCoeff(&largest);
            QCOMPARE(int(largest), found->labels[std::size_t(i)]);
            QVERIFY(std::abs(found->probabilities.row(i).sum() - 1) < 1e-12);
        }
    }
    void nothingMakesACovarianceSingular_data()
    {
        QTest::addColumn<Eigen::MatrixXd>("items");
        QTest::newRow("all the same") << Eigen::MatrixXd(Eigen::MatrixXd::Ones(10, 3));
        Eigen::MatrixXd pairs(10, 3);
        for (int i = 0; i < 10; ++i)
            pairs.row(i).setConstant(i / 5);
        QTest::newRow("two places") << pairs;
        QTest::newRow("three items") << Eigen::MatrixXd(
            (Eigen::MatrixXd(3, 3) << 1, 2, 3, 4, 5, 7, 7, 8, 8).finished());
        Eigen::MatrixXd line(20, 3);
        for (int i = 0; i < 20; ++i)
            line.row(i) << i, 2 * i, -3 * i;
        QTest::newRow("on a line") << line;
        Eigen::MatrixXd constant = paperAppendix().parameters;
        constant.col(1).setConstant(4);
        QTest::newRow("a constant column") << constant;
        Eigen::MatrixXd outlier = paperAppendix().parameters;
        outlier.row(3) *= 1e6;
        QTest::newRow("an outlier") << outlier;
        QTest::newRow("tiny") << Eigen::MatrixXd(paperAppendix().parameters * 1e-140);
        QTest::newRow("huge") << Eigen::MatrixXd(paperAppendix().parameters * 1e140);
    }
    void nothingMakesACovarianceSingular()
    {
        QFETCH(Eigen::MatrixXd, items);
        for (const MixtureCovariance kind : {MixtureCovariance::Tied, MixtureCovariance::Full})
            for (const int components : {1, 2, 3}) {
                GaussianMixtureOptions options;
                options.components = components;
                options.covariance = kind;
                const auto found = gaussianMixture(items, options);
                QVERIFY(found->status != MixtureStatus::TooFewItems);
                QVERIFY(std::isfinite(found->logLikelihood) && std::isfinite(found->bic));
                QVERIFY(found->parameters.means.allFinite() && found->probabilities.allFinite());
                QVERIFY(allPositiveDefinite(found->parameters));
            }
    }
    void theSameSeedGivesTheSameMixtureAlsoInManyChunks()
    {
        const Labelled needles = twoNeedles(20'000);
        GaussianMixtureOptions options;
        options.components = 2;
        options.restarts = 2;
        options.recordSteps = false;
        const auto one = gaussianMixture(needles.items, options);
        const auto two = gaussianMixture(needles.items, options);
        QVERIFY(one->parameters.means == two->parameters.means);
        QCOMPARE(one->logLikelihood, two->logLikelihood);
        QCOMPARE(one->labels, two->labels);
        QVERIFY(one->steps.empty());
    }
    void badOptionsAndNumbersAreErrors()
    {
        for (int GaussianMixtureOptions::*option :
             {&GaussianMixtureOptions::components, &GaussianMixtureOptions::restarts,
              &GaussianMixtureOptions::maxIterations}) {
            GaussianMixtureOptions options;
            options.*option = 0;
            QCOMPARE(gaussianMixture(Eigen::MatrixXd::Ones(9, 2), options).error().code, ErrorCode::Usage);
        }
        QCOMPARE(gaussianMixture(Eigen::MatrixXd::Constant(9, 2, std::nan(""))).error().code,
                 ErrorCode::BadInput);
        QVERIFY(gaussianMixture(Eigen::MatrixXd::Ones(3, 2))->status == MixtureStatus::TooFewItems);
        QVERIFY(gaussianMixture(Eigen::MatrixXd(9, 0))->status == MixtureStatus::TooFewItems);
    }
};

GRIPSCOPE_TEST(GaussianMixtureTest)
#include "gaussian_mixture_test.moc"
