// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/feature_scaling.h"
#include "core/clustering/kmeans.h"
#include "core/clustering/kmeans_assignment.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/research/paper_reproduction.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

QJsonObject oracle()
{
    QFile file(QStringLiteral(GRIPSCOPE_TEST_DATA) + u"/kmeans_oracle.json"_s);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

/// Inertias of the global optimum from the oracle, to the 9 digits that are asked for.
bool sameTo9Digits(double found, double wanted)
{
    return std::abs(found - wanted) <= 1e-9 * std::abs(wanted);
}

std::size_t usedClusters(const std::vector<int>& labels)
{
    return std::set<int>(labels.begin(), labels.end()).size();
}

Eigen::MatrixXd column(std::initializer_list<double> values)
{
    Eigen::MatrixXd items(Eigen::Index(values.size()), 1);
    std::copy(values.begin(), values.end(), items.data());
    return items;
}

/// `clusters` round clouds and as many items between them, shuffled over the table.
Eigen::MatrixXd clouds(Eigen::Index items, int features, int clusters, std::uint64_t seed)
{
    GaussianNoise noise(seed);
    Eigen::MatrixXd centres(clusters, features);
    for (double& x : centres.reshaped())
        x = 10 * noise.uniform();
    Eigen::MatrixXd table(items, features);
    for (Eigen::Index i = 0; i < items; ++i)
        for (Eigen::Index j = 0; j < features; ++j)
            table(i, j) =
                i % 2 == 0 ? 10 * noise.uniform() : centres(Eigen::Index(i / 2) % clusters, j) + noise();
    return table;
}

/// Lloyd's iteration without any short cut: every distance is measured.
struct PlainLloyd {
    Eigen::MatrixXd items, centroids;
    std::vector<int> labels;

    void assign()
    {
        labels.assign(std::size_t(items.rows()), 0);
        for (Eigen::Index i = 0; i < items.rows(); ++i) {
            double nearest = std::numeric_limits<double>::infinity();
            for (Eigen::Index c = 0; c < centroids.rows(); ++c) {
                double squared = 0;
                for (Eigen::Index j = 0; j < items.cols(); ++j)
                    squared += (items(i, j) - centroids(c, j)) * (items(i, j) - centroids(c, j));
                if (squared < nearest) {
                    nearest = squared;
                    labels[std::size_t(i)] = int(c);
                }
            }
        }
    }
    void moveToMeans()
    {
        Eigen::VectorXd counts = Eigen::VectorXd::Zero(centroids.rows());
        centroids.setZero();
        for (Eigen::Index i = 0; i < items.rows(); ++i) {
            centroids.row(labels[std::size_t(i)]) += items.row(i);
            counts(labels[std::size_t(i)]) += 1;
        }
        for (Eigen::Index c = 0; c < centroids.rows(); ++c)
            centroids.row(c) /= counts(c);
    }
};

/// The partition alone, whatever the clusters' numbers.
std::vector<int> byAppearance(const std::vector<int>& labels)
{
    std::vector<int> numbers(labels.size() + 1, -1);
    std::vector<int> renumbered;
    int next = 0;
    for (const int label : labels) {
        if (numbers[std::size_t(label)] < 0)
            numbers[std::size_t(label)] = next++;
        renumbered.push_back(numbers[std::size_t(label)]);
    }
    return renumbered;
}

} // namespace

class KmeansTest : public QObject {
    Q_OBJECT
private slots:
    void nearestIsTheSameOnEveryProcessor()
    {
        GaussianNoise draw(3);
        for (const Eigen::Index features : {1, 2, 3, 5}) {
            std::vector<double> columns(std::size_t(features * blockItems));
            for (double& x : columns)
                x = draw();
            ItemRows centroids(6, features);
            for (double& x : centroids.reshaped())
                x = draw();
            centroids.row(1) = Eigen::Map<Eigen::MatrixXd>(columns.data(), blockItems, features).row(20);
            centroids.row(4) = centroids.row(1); // of equals the lowest number
            std::vector<int> found(std::size_t(blockItems), -1), plain(std::size_t(blockItems), -1);
            found[20] = plain[20] = 1;
            QCOMPARE(assignBlock(columns.data(), features, centroids, found.data()), int(blockItems) - 1);
            QCOMPARE(detail::assignOneByOne(columns.data(), features, centroids, plain.data()),
                     int(blockItems) - 1);
            QCOMPARE(found, plain);
            QCOMPARE(found[20], 1);
            QCOMPARE(std::count(found.begin(), found.end(), 4), 0);
            QCOMPARE(assignBlock(columns.data(), features, centroids, found.data()), 0);
        }
    }

    void reachesTheOptimumOnTheAppendix_data()
    {
        QTest::addColumn<FeatureScaling>("scaling");
        QTest::addColumn<QString>("key");
        QTest::newRow("raw") << FeatureScaling::None << u"raw"_s;
        QTest::newRow("zscore") << FeatureScaling::ZScore << u"z_pop"_s;
        QTest::newRow("log") << FeatureScaling::Log << u"log"_s;
        QTest::newRow("zlog") << FeatureScaling::ZLog << u"zlog"_s;
    }
    void reachesTheOptimumOnTheAppendix()
    {
        QFETCH(FeatureScaling, scaling);
        QFETCH(QString, key);
        const QJsonObject wanted = oracle()[u"scalings"_s][key].toObject();
        QVERIFY(!wanted.isEmpty());
        const PaperClustering found = clusterPaperAppendix(scaling);
        QVERIFY(found.result.status == KMeansStatus::Converged);
        QVERIFY(sameTo9Digits(found.result.inertia, wanted[u"best_sse_K4"_s].toDouble()));
        QCOMPARE(found.agreement.adjustedRandIndex, 1.0);
        const QJsonArray centroids = wanted[u"centroids"_s].toArray();
        for (int c = 0; c < 4; ++c) // the oracle's order A to D is that of first appearance
            for (int j = 0; j < 3; ++j)
                // Means of 10 numbers of size 1: rounding stays far below 1e-12.
                QVERIFY(std::abs(found.result.centroids(c, j) - centroids[c][j].toDouble()) < 1e-12);
    }
    void everySeedReachesIt_data() { reachesTheOptimumOnTheAppendix_data(); }
    void everySeedReachesIt()
    {
        QFETCH(FeatureScaling, scaling);
        QFETCH(QString, key);
        const double wanted = oracle()[u"scalings"_s][key][u"best_sse_K4"_s].toDouble();
        for (std::uint64_t seed = 1; seed <= 50; ++seed)
            QVERIFY2(sameTo9Digits(clusterPaperAppendix(scaling, seed).result.inertia, wanted),
                     qPrintable(QString::number(seed)));
    }
    void publishedInertiasAreTheOraclesOwn()
    {
        QVERIFY(sameTo9Digits(clusterPaperAppendix(FeatureScaling::None).result.inertia, 0.0011127767646));
        QVERIFY(sameTo9Digits(clusterPaperAppendix(FeatureScaling::ZScore).result.inertia, 3.14528774528));
        QVERIFY(sameTo9Digits(clusterPaperAppendix(FeatureScaling::Log).result.inertia, 0.161962421918));
    }
    void everyStepIsThatOfPlainLloyd_data()
    {
        QTest::addColumn<int>("items");
        QTest::addColumn<int>("features");
        QTest::addColumn<int>("clusters");
        QTest::addColumn<double>("unit");
        QTest::newRow("m, b, k") << 3000 << 3 << 4 << 1.0;
        QTest::newRow("many clusters") << 3000 << 3 << 40 << 1.0;
        QTest::newRow("a line") << 500 << 1 << 5 << 1.0;
        QTest::newRow("a plane") << 800 << 2 << 7 << 1.0;
        QTest::newRow("five features") << 800 << 5 << 6 << 1.0;
        QTest::newRow("many clusters of five features") << 3000 << 5 << 20 << 1.0;
        QTest::newRow("as many as are measured in full") << 2000 << 3 << 8 << 1.0;
        QTest::newRow("one more") << 2000 << 3 << 9 << 1.0;
        QTest::newRow("tiny numbers") << 500 << 3 << 4 << 1e-200; // whose squares vanish
        QTest::newRow("huge numbers") << 500 << 3 << 4 << 1e140;
    }
    void everyStepIsThatOfPlainLloyd()
    {
        QFETCH(int, items);
        QFETCH(int, features);
        QFETCH(int, clusters);
        QFETCH(double, unit);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const Eigen::MatrixXd table = clouds(items, features, clusters, seed);
            PlainLloyd lloyd{table, table.topRows(clusters), {}};
            const auto result = kMeansFrom(table * unit, table.topRows(clusters) * unit);
            QVERIFY(result->status == KMeansStatus::Converged);
            QVERIFY(result->steps.size() > 3);
            for (std::size_t s = 0; s < result->steps.size(); ++s) {
                lloyd.assign();
                QCOMPARE(byAppearance(result->steps[s].labels), byAppearance(lloyd.labels));
                lloyd.moveToMeans();
            }
            QCOMPARE(result->labels, byAppearance(lloyd.labels));
        }
    }
    void equalDistancesGoToTheLowestNumberAsInPlainLloyd_data()
    {
        QTest::addColumn<int>("clusters");
        QTest::newRow("few") << 3;
        QTest::newRow("many") << 15;
    }
    void equalDistancesGoToTheLowestNumberAsInPlainLloyd()
    {
        QFETCH(int, clusters);
        // Whole numbers: every item between two centroids is exactly between them, and stays so. The
        // centroids come in falling order, so that the lower number is on the other side.
        const int last = 4 * clusters - 4;
        Eigen::MatrixXd items(2 * clusters * clusters, 1); // repeated, so that neighbours are sought at all
        for (Eigen::Index i = 0; i < items.rows(); ++i)
            items(i, 0) = double(2 * (i % (2 * clusters - 1)));
        Eigen::MatrixXd centres(clusters, 1);
        for (int c = 0; c < clusters; ++c)
            centres(c, 0) = last - 4 * c;
        PlainLloyd lloyd{items, centres, {}};
        const auto result = kMeansFrom(items, centres);
        for (const KMeansStep& step : result->steps) {
            lloyd.assign();
            QCOMPARE(byAppearance(step.labels), byAppearance(lloyd.labels));
            lloyd.moveToMeans();
        }
    }
    void aLongTableDoesNotDependOnTheProcessors()
    {
        // More than one chunk of the table: the sums come together in the order of the chunks.
        const Eigen::MatrixXd table = clouds(20'000, 3, 5, 3);
        KMeansOptions options;
        options.clusters = 5;
        options.restarts = 2;
        const auto one = kMeans(table, options);
        const auto two = kMeans(table, options);
        QVERIFY(one->centroids == two->centroids);
        QCOMPARE(one->labels, two->labels);
        QCOMPARE(one->inertia, two->inertia);
        PlainLloyd lloyd{table, one->centroids, {}};
        lloyd.assign();
        QCOMPARE(lloyd.labels, one->labels);
        lloyd.moveToMeans();
        // Means of 4,000 numbers below 20 added in another order: 4,000 x 20 x 1e-16 at the very most.
        QVERIFY((lloyd.centroids - one->centroids).cwiseAbs().maxCoeff() < 1e-11);
    }
    void noSingleItemWantsToMove()
    {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Eigen::MatrixXd items = clouds(60, 2, 4, seed);
            KMeansOptions options;
            options.restarts = 1;
            options.seed = seed;
            const auto found = kMeans(items, options);
            QVERIFY(found->status == KMeansStatus::Converged);
            for (std::size_t i = 0; i < 60; ++i)
                for (int to = 0; to < 4; ++to) {
                    PlainLloyd moved{items, found->centroids, found->labels};
                    moved.labels[i] = to;
                    moved.moveToMeans();
                    double inertia = 0;
                    for (Eigen::Index j = 0; j < 60; ++j)
                        inertia +=
                            (items.row(j) - moved.centroids.row(moved.labels[std::size_t(j)])).squaredNorm();
                    // NaN where the item was alone in its cluster: no move then.
                    QVERIFY(!(inertia < found->inertia * (1 - 1e-9)));
                }
        }
    }
    void stepsAreLeftOutWhenNotWanted()
    {
        KMeansOptions options;
        options.recordSteps = false;
        const auto result = kMeans(paperAppendix().parameters, options);
        QVERIFY(result->steps.empty());
        QCOMPARE(result->labels, kMeans(paperAppendix().parameters)->labels);
    }
    void centresThatDoNotFitAreAnError()
    {
        QCOMPARE(kMeansFrom(column({1, 2}), Eigen::MatrixXd::Zero(1, 2)).error().code, ErrorCode::Usage);
        QCOMPARE(kMeansFrom(column({1, 2}), Eigen::MatrixXd(0, 1)).error().code, ErrorCode::Usage);
        QCOMPARE(kMeansFrom(column({1, 2}), column({1e300})).error().code, ErrorCode::BadInput);
        QVERIFY(kMeansFrom(column({1}), column({1, 2}))->status == KMeansStatus::TooFewItems);
    }
    void theSameSeedGivesTheSameSteps()
    {
        const PaperClustering one = clusterPaperAppendix(FeatureScaling::ZScore, 7);
        const PaperClustering two = clusterPaperAppendix(FeatureScaling::ZScore, 7);
        QCOMPARE(one.result.steps.size(), two.result.steps.size());
        for (std::size_t i = 0; i < one.result.steps.size(); ++i) {
            QVERIFY(one.result.steps[i].centroids == two.result.steps[i].centroids);
            QCOMPARE(one.result.steps[i].labels, two.result.steps[i].labels);
        }
    }
    void inertiaNeverRisesFromStepToStepAndEndsAtTheResult()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const KMeansResult result = clusterPaperAppendix(FeatureScaling::None, seed).result;
            QVERIFY(result.steps.size() >= 2);
            QCOMPARE(int(result.steps.size()), result.iterations + 1);
            for (std::size_t i = 1; i < result.steps.size(); ++i)
                QVERIFY(result.steps[i].inertia <= result.steps[i - 1].inertia * (1 + 1e-12));
            QCOMPARE(result.steps.back().inertia, result.inertia);
            QCOMPARE(result.steps.back().labels, result.labels);
            QVERIFY(result.steps.back().centroids == result.centroids);
        }
    }
    void theFirstCentresAreItems()
    {
        const PaperClustering found = clusterPaperAppendix(FeatureScaling::None);
        const Eigen::MatrixXd& items = paperAppendix().parameters;
        for (Eigen::Index c = 0; c < 4; ++c)
            QCOMPARE(
                (items.rowwise() - found.result.steps.front().centroids.row(c)).rowwise().norm().minCoeff(),
                0.0);
    }
    void labelsAreNumberedByFirstAppearance()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            KMeansOptions options;
            options.clusters = 3;
            options.seed = seed;
            const auto result = kMeans(column({9, 9.1, 1, 1.1, 5, 5.1}), options);
            QCOMPARE(result->labels, std::vector<int>({0, 0, 1, 1, 2, 2}));
            QVERIFY(std::abs(result->centroids(1, 0) - 1.05) < 1e-12);
        }
    }
    void asManyClustersAsItemsLeavesNothingOver()
    {
        KMeansOptions options;
        options.clusters = 3;
        const auto result = kMeans(column({3, 1, 2}), options);
        QCOMPARE(result->inertia, 0.0);
        QCOMPARE(result->labels, std::vector<int>({0, 1, 2}));
    }
    void fewerItemsThanClustersIsAStatus()
    {
        const auto result = kMeans(column({1, 2, 3}));
        QVERIFY(result->status == KMeansStatus::TooFewItems);
        QVERIFY(result->labels.empty());
        QVERIFY(kMeans(Eigen::MatrixXd(0, 3))->status == KMeansStatus::TooFewItems);
    }
    void fewerDifferentItemsThanClustersLeavesClustersEmpty()
    {
        KMeansOptions options;
        options.clusters = 4;
        const auto result = kMeans(column({1, 1, 1, 2, 2, 2}), options);
        QVERIFY(result->status == KMeansStatus::Converged);
        QCOMPARE(result->inertia, 0.0);
        QCOMPARE(result->labels, std::vector<int>({0, 0, 0, 1, 1, 1}));
        QVERIFY(result->centroids.allFinite());
    }
    void farMoreClustersThanPlacesComesToRest()
    {
        // The mean of equal numbers is off by a rounding, for which no empty cluster is to move: it would
        // take these items over, and the next iteration would do the same to it.
        Eigen::MatrixXd items(300, 2);
        for (int i = 0; i < 300; ++i)
            items.row(i) << 0.1 * (i % 5), 0.3 * (i % 3);
        KMeansOptions options;
        options.clusters = 40;
        const auto result = kMeans(items, options);
        QVERIFY(result->status == KMeansStatus::Converged);
        QVERIFY(result->iterations < 10);
        QCOMPARE(usedClusters(result->labels), std::size_t(15));
        QVERIFY(result->inertia < 1e-25);
    }
    void aClusterThatRunsEmptyIsFilledAgain()
    {
        // From the first three items as centres the middle one has lost all its items after two steps (found
        // by search). One start in a thousand or so begins there.
        Eigen::MatrixXd items(6, 2);
        items << 5, 11, 6, 10, 8, 11, 11, 10, 2, 4, 0, 6;
        KMeansOptions options;
        options.clusters = 3;
        options.candidates = 1;
        options.restarts = 1;
        bool emptied = false;
        for (options.seed = 1; options.seed <= 5000; ++options.seed) {
            const auto result = kMeans(items, options);
            QCOMPARE(usedClusters(result->labels), std::size_t(3));
            emptied =
                emptied || std::any_of(result->steps.begin(), result->steps.end(),
                                       [](const KMeansStep& step) { return usedClusters(step.labels) < 3; });
        }
        QVERIFY(emptied);
    }
    void stopsAtTheIterationLimitAndSaysSo()
    {
        KMeansOptions options;
        options.maxIterations = 1;
        options.restarts = 1;
        options.candidates = 1;
        bool stopped = false;
        for (options.seed = 1; options.seed <= 20; ++options.seed) {
            const auto result = kMeans(paperAppendix().parameters, options);
            QCOMPARE(result->iterations, 1);
            stopped = stopped || result->status == KMeansStatus::NotConverged;
        }
        QVERIFY(stopped);
    }
    void badOptionsAndNumbersAreErrors()
    {
        for (int KMeansOptions::*option : {&KMeansOptions::clusters, &KMeansOptions::restarts,
                                           &KMeansOptions::candidates, &KMeansOptions::maxIterations}) {
            KMeansOptions options;
            options.*option = 0;
            QCOMPARE(kMeans(column({1, 2, 3, 4}), options).error().code, ErrorCode::Usage);
        }
        QCOMPARE(kMeans(column({1e200, -1e200, 0, 4})).error().code, ErrorCode::BadInput);
        QCOMPARE(kMeans(column({1e308, 1e308, 1e308, 1e308})).error().code, ErrorCode::BadInput);
        QVERIFY(kMeans(column({1e150, -1e150, 0, 4}))->centroids.allFinite());
        QCOMPARE(kMeans(column({1, 2, std::nan(""), 4})).error().code, ErrorCode::BadInput);
        QCOMPARE(kMeans(column({1, 2, std::numeric_limits<double>::infinity(), 4})).error().code,
                 ErrorCode::BadInput);
    }
};

GRIPSCOPE_TEST(KmeansTest)
#include "kmeans_test.moc"
