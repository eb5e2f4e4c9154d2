// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_advice.h"
#include "core/clustering/feature_scaling.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/paper_appendix.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

Eigen::MatrixXd appendix(FeatureScaling scaling)
{
    const Eigen::MatrixXd& items = paperAppendix().parameters;
    return featureTransform(items, scaling)->apply(items);
}

/// Round clouds of standard deviation 1, their centres `apart` from each other on a line, in turns.
Eigen::MatrixXd clouds(int items, int count, double apart)
{
    GaussianNoise noise(8);
    Eigen::MatrixXd table(items, 3);
    for (int i = 0; i < items; ++i)
        table.row(i) << noise() + apart * (i % count), noise(), noise();
    return table;
}

std::optional<int> vote(const ClusterAdvice& advice, ClusterCriterion criterion)
{
    for (const ClusterVote& one : advice.votes)
        if (one.criterion == criterion)
            return one.clusters;
    return {};
}

} // namespace

class ClusterAdviceTest : public QObject {
    Q_OBJECT
private slots:
    void zScoresOfThePapersTableHaveFourGroups()
    {
        const auto advice = adviseClusters(appendix(FeatureScaling::ZScore));
        for (const ClusterCriterion criterion :
             {ClusterCriterion::Silhouette, ClusterCriterion::CalinskiHarabasz,
              ClusterCriterion::DaviesBouldin})
            QCOMPARE(vote(*advice, criterion), std::optional(4));
        QCOMPARE(advice->clusters, 4);
        QVERIFY(advice->reason.describe().startsWith(
            u"4 groups: silhouette, Calinski-Harabasz, Davies-Bouldin"_s));
        QCOMPARE(advice->figures.size(), std::size_t(8));
        QCOMPARE(advice->itemsUsed, Eigen::Index(40));
        QVERIFY(std::abs(advice->figures[3].inertia - 3.14528774528) < 1e-10);
    }
    void onRawFeaturesTheSilhouetteSaysThree()
    {
        const auto advice = adviseClusters(appendix(FeatureScaling::None));
        QCOMPARE(vote(*advice, ClusterCriterion::Silhouette), std::optional(3));
    }
    void oneCloudIsOneGroup()
    {
        const auto advice = adviseClusters(clouds(200, 1, 0));
        QCOMPARE(vote(*advice, ClusterCriterion::Gap), std::optional(1));
        QCOMPARE(vote(*advice, ClusterCriterion::Bic), std::optional(1));
        QCOMPARE(advice->clusters, 1);
        QVERIFY(advice->reason.describe().startsWith(u"One group"_s));
    }
    void cloudsFarApartAreCounted_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {2, 3, 5})
            QTest::addRow("%d", count) << count;
    }
    void cloudsFarApartAreCounted()
    {
        QFETCH(int, count);
        const auto advice = adviseClusters(clouds(60 * count, count, 12));
        for (const ClusterVote& one : advice->votes)
            QVERIFY2(one.clusters == count, qPrintable(toString(one.criterion)));
        QCOMPARE(advice->clusters, count);
    }
    void theUnitOfTheTableMakesNoDifference()
    {
        const Eigen::MatrixXd items = clouds(90, 3, 8);
        const auto one = adviseClusters(items);
        for (const double unit : {0x1p-700, 0x1p+400}) {
            const auto other = adviseClusters(items * unit);
            QCOMPARE(other->reason, one->reason);
            QCOMPARE(other->figures[2].silhouette, one->figures[2].silhouette);
            QVERIFY(std::abs(other->figures[2].gap->value - one->figures[2].gap->value) < 1e-9);
        }
    }
    void itemsInAFewPlacesAreAsManyGroups()
    {
        Eigen::MatrixXd items(20, 2);
        for (int i = 0; i < 20; ++i)
            items.row(i) << (i % 4 == 0), (i % 4 == 1); // (1, 0), (0, 1) and (0, 0)
        const auto advice = adviseClusters(items);
        QCOMPARE(advice->figures.size(), std::size_t(3));
        QCOMPARE(advice->clusters, 3);
        QCOMPARE(advice->figures[2].silhouette, std::optional(1.0));
        QVERIFY(!advice->figures[2].calinskiHarabasz && !advice->figures[2].gap);
    }
    void nothingToGroupIsOneGroup()
    {
        QCOMPARE(adviseClusters(Eigen::MatrixXd::Ones(5, 3))->clusters, 1);
        QCOMPARE(adviseClusters(Eigen::MatrixXd::Ones(1, 3))->clusters, 1);
    }
    void aLongTableIsJudgedByAPart()
    {
        ClusterAdviceOptions options;
        options.mostItems = 300;
        options.maxClusters = 5;
        const auto advice = adviseClusters(clouds(20'000, 3, 12), options);
        QCOMPARE(advice->itemsUsed, Eigen::Index(300));
        QCOMPARE(advice->clusters, 3);
        QCOMPARE(adviseClusters(clouds(20'000, 3, 12), options)->figures[2].inertia,
                 advice->figures[2].inertia);
    }
    void theGapOfAnEvenTableIsNearZero()
    {
        // Items spread as the references are: their ln W differs by no more than its scatter from reference
        // to reference. Five of its deviations.
        GaussianNoise noise(2);
        Eigen::MatrixXd items(400, 2);
        for (double& x : items.reshaped())
            x = noise.uniform();
        items.col(0) *= 5; // so that the principal axes are those of the rectangle
        const auto advice = adviseClusters(items);
        for (const ClusterFigures& figures : advice->figures)
            QVERIFY(std::abs(figures.gap->value) < 5 * figures.gap->error + 0.02); // its box is a bit wider
    }
    void theGapRuleIsTheSmallestWithinAnErrorOfTheFirstMaximum()
    {
        QCOMPARE(clustersByGap({GapStatistic{0, 0.1}, GapStatistic{1, 0.1}, GapStatistic{1.05, 0.1},
                                GapStatistic{0.9, 0.1}, GapStatistic{2, 0.1}}),
                 std::optional(2));
        QCOMPARE(clustersByGap({GapStatistic{1, 0.1}, GapStatistic{0.9, 0.1}}), std::optional(1));
        QCOMPARE(clustersByGap({GapStatistic{0, 0.1}, GapStatistic{1, 0.1}}), std::nullopt); // still rising
        QCOMPARE(clustersByGap({GapStatistic{0, 0.1}, GapStatistic{1, 0.1}, std::nullopt}), std::nullopt);
        QCOMPARE(clustersByGap({}), std::nullopt);
    }
    void badOptionsAndNumbersAreErrors()
    {
        ClusterAdviceOptions options;
        options.maxClusters = 0;
        QCOMPARE(adviseClusters(Eigen::MatrixXd::Ones(5, 3), options).error().code, ErrorCode::Usage);
        options = {};
        options.mostItems = 0;
        QCOMPARE(adviseClusters(Eigen::MatrixXd::Ones(5, 3), options).error().code, ErrorCode::Usage);
        QCOMPARE(adviseClusters(Eigen::MatrixXd(0, 3)).error().code, ErrorCode::BadInput);
        QCOMPARE(adviseClusters(Eigen::MatrixXd::Constant(5, 3, std::nan(""))).error().code,
                 ErrorCode::BadInput);
    }
};

GRIPSCOPE_TEST(ClusterAdviceTest)
#include "cluster_advice_test.moc"
