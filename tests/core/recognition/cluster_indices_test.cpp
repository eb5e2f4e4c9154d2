// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_advice.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

Eigen::MatrixXd fourPoints()
{
    return Eigen::Vector4d(0, 2, 10, 12);
}

bool near(std::optional<double> found, double wanted)
{
    return found && std::abs(*found - wanted) < 1e-14 * std::abs(wanted); // some roundings of numbers near 1
}

} // namespace

class ClusterIndicesTest : public QObject {
    Q_OBJECT
private slots:
    void twoPairsOnALineByHand()
    {
        const std::vector<int> labels{0, 0, 1, 1};
        // Of 0: a = 2, b = (10 + 12) / 2; of 2: a = 2, b = (8 + 10) / 2; the other pair is its mirror image.
        QVERIFY(near(silhouette(fourPoints(), labels), (9.0 / 11 + 7.0 / 9) / 2));
        // Means 1 and 11 about 6: B = 4 x 25; W = 4 x 1.
        QVERIFY(near(calinskiHarabasz(fourPoints(), labels), (100.0 / 1) / (4.0 / 2)));
        QVERIFY(near(daviesBouldin(fourPoints(), labels), (1.0 + 1.0) / 10));
    }
    void anItemAloneCountsZeroInTheSilhouette()
    {
        // Of 0: a = 2, b = 10; of 2: a = 2, b = 8; 10 is alone.
        QVERIFY(near(silhouette(Eigen::Vector3d(0, 2, 10), {0, 0, 1}), (8.0 / 10 + 6.0 / 8 + 0) / 3));
    }
    void aWrongGroupingHasANegativeSilhouette()
    {
        QVERIFY(silhouette(fourPoints(), {0, 1, 0, 1}).value() < 0);
    }
    void numbersOfClustersMayHaveGaps()
    {
        for (const auto index : {silhouette, calinskiHarabasz, daviesBouldin})
            QCOMPARE(index(fourPoints(), {7, 7, 3, 3}), index(fourPoints(), {0, 0, 1, 1}));
    }
    void whatDoesNotExistIsNothing()
    {
        for (const auto index : {silhouette, calinskiHarabasz, daviesBouldin}) {
            QVERIFY(!index(fourPoints(), {0, 0, 0, 0})); // one cluster
            QVERIFY(!index(fourPoints(), {0, 1, 2, 3})); // nothing but clusters of one
            QVERIFY(!index(Eigen::MatrixXd(0, 3), {}));  // no items
        }
        // Clusters without width are perfect, which Calinski-Harabasz has no number for.
        const Eigen::MatrixXd pairs = Eigen::Vector4d(1, 1, 2, 2);
        QCOMPARE(silhouette(pairs, {0, 0, 1, 1}), std::optional(1.0));
        QVERIFY(!calinskiHarabasz(pairs, {0, 0, 1, 1}));
        QCOMPARE(daviesBouldin(pairs, {0, 0, 1, 1}), std::optional(0.0));
        // Everything in one place: no distance between the centres either.
        QVERIFY(!daviesBouldin(Eigen::MatrixXd::Ones(4, 1), {0, 0, 1, 1}));
        QCOMPARE(silhouette(Eigen::MatrixXd::Ones(4, 1), {0, 0, 1, 1}), std::optional(0.0));
    }
};

GRIPSCOPE_TEST(ClusterIndicesTest)
#include "cluster_indices_test.moc"
