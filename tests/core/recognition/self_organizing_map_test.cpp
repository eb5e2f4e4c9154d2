// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_agreement.h"
#include "core/clustering/feature_scaling.h"
#include "core/clustering/self_organizing_map.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/paper_appendix.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;

namespace {

/// Items spread evenly over the unit square or cube.
Eigen::MatrixXd evenly(int items, int features, std::uint64_t seed = 3)
{
    GaussianNoise noise(seed);
    Eigen::MatrixXd table(items, features);
    for (double& x : table.reshaped())
        x = noise.uniform();
    return table;
}

SelfOrganizingMapOptions grid(int rows, int columns, int groups = 1)
{
    SelfOrganizingMapOptions options;
    options.rows = rows;
    options.columns = columns;
    options.groups = groups;
    return options;
}

Eigen::MatrixXd zScores()
{
    const Eigen::MatrixXd& items = paperAppendix().parameters;
    return featureTransform(items, FeatureScaling::ZScore)->apply(items);
}

} // namespace

class SelfOrganizingMapTest : public QObject {
    Q_OBJECT
private slots:
    void thePapersFourTypesArePure()
    {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            SelfOrganizingMapOptions options;
            options.seed = seed;
            options.restarts = 3;
            const auto found = selfOrganizingMap(zScores(), options);
            QVERIFY(found->status == SelfOrganizingMapStatus::Converged);
            QCOMPARE(clusterAgreement(paperAppendix().object, found->labels, 4).adjustedRandIndex, 1.0);
            for (int c = 0; c < 4; ++c) // numbered by first appearance
                QCOMPARE(found->labels[std::size_t(10 * c)], c);
            for (int c = 0; c < 4; ++c)
                QVERIFY((found->centroids.row(c) - zScores().middleRows(10 * c, 10).colwise().mean()).norm() <
                        1e-12);
        }
    }
    void theFiguresAreWhatTheirDefinitionsSay()
    {
        const Eigen::MatrixXd items = evenly(300, 3);
        const auto found = selfOrganizingMap(items, grid(5, 4));
        double distance = 0;
        int torn = 0;
        std::vector<int> hits(20, 0);
        for (Eigen::Index i = 0; i < items.rows(); ++i) {
            Eigen::VectorXd away = (found->weights.rowwise() - items.row(i)).rowwise().norm();
            Eigen::Index best = 0;
            distance += away.minCoeff(&best);
            away(best) = 1e9;
            Eigen::Index second = 0;
            away.minCoeff(&second);
            torn += std::max(std::abs(best / 4 - second / 4), std::abs(best % 4 - second % 4)) > 1;
            QCOMPARE(found->unitOfItem[std::size_t(i)], int(best));
            ++hits[std::size_t(best)];
        }
        QVERIFY(std::abs(found->quantizationError - distance / 300) < 1e-12);
        QCOMPARE(found->topographicError, torn / 300.0);
        QCOMPARE(found->hits, hits);
    }
    void aTrainedMapIsAFixedPoint()
    {
        // Converged: moving every unit to its weighted mean once more changes nothing.
        const Eigen::MatrixXd items = evenly(200, 2);
        const auto found = selfOrganizingMap(items, grid(4, 4));
        QVERIFY(found->status == SelfOrganizingMapStatus::Converged);
        for (int unit = 0; unit < 16; ++unit) {
            Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(2);
            double mass = 0;
            for (Eigen::Index i = 0; i < items.rows(); ++i) {
                const int best = found->unitOfItem[std::size_t(i)];
                const double down = unit / 4 - best / 4;
                const double across = unit % 4 - best % 4;
                const double h = std::exp(-(down * down + across * across) / (2 * 0.5 * 0.5));
                sum += h * items.row(i);
                mass += h;
            }
            QVERIFY((sum / mass - found->weights.row(unit)).norm() < 1e-12);
        }
    }
    void neighboursOnTheMapAreNeighboursInTheTable()
    {
        // A chain on a line is in order, a sheet on a square is not folded.
        const auto chain = selfOrganizingMap(evenly(300, 1), grid(1, 12));
        std::vector<double> weights(chain->weights.data(), chain->weights.data() + 12);
        if (weights.front() > weights.back())
            std::reverse(weights.begin(), weights.end());
        QVERIFY(std::is_sorted(weights.begin(), weights.end()));
        QCOMPARE(chain->topographicError, 0.0);
        // Where four units meet, rounding of the cells makes a diagonal or farther unit second now and then.
        QVERIFY(selfOrganizingMap(evenly(1000, 2), grid(8, 8))->topographicError < 0.05);
    }
    void aFinerMapQuantizesFiner()
    {
        const Eigen::MatrixXd items = evenly(500, 2);
        double before = 1;
        for (const int side : {2, 4, 8}) {
            const double error = selfOrganizingMap(items, grid(side, side))->quantizationError;
            // Twice as many units a side make the cells half as wide; the neighbourhood costs some of it.
            QVERIFY(error < 0.7 * before);
            before = error;
        }
    }
    void theUMatrixIsHighBetweenTheGroups()
    {
        // Two clouds ten apart on a chain: the ridge is where the groups meet.
        Eigen::MatrixXd items = evenly(100, 2);
        items.topRows(50).col(0).array() += 10;
        const auto found = selfOrganizingMap(items, grid(1, 10, 2));
        const Eigen::MatrixXd heights = found->uMatrix();
        Eigen::Index ridge = 0;
        heights.row(0).maxCoeff(&ridge);
        const auto border =
            std::adjacent_find(found->groupOfUnit.begin(), found->groupOfUnit.end(), std::not_equal_to<>()) -
            found->groupOfUnit.begin();
        QVERIFY(std::abs(ridge - border) <= 1);
        for (int i = 0; i < 100; ++i)
            QCOMPARE(found->labels[std::size_t(i)], i < 50 ? 0 : 1);
    }
    void uMatrixAndPlanesByHand()
    {
        SelfOrganizingMapResult map;
        map.rows = 2;
        map.columns = 2;
        map.weights.resize(4, 2);
        map.weights << 0, 5, 3, 5, 0, 9, 3, 9; // a rectangle of 3 by 4: its diagonals are 5
        QVERIFY(map.uMatrix().isApproxToConstant((3.0 + 4 + 5) / 3));
        QCOMPARE(Eigen::MatrixXd(map.componentPlane(0)),
                 Eigen::MatrixXd((Eigen::Matrix2d() << 0, 3, 0, 3).finished()));
        QCOMPARE(Eigen::MatrixXd(map.componentPlane(1)),
                 Eigen::MatrixXd((Eigen::Matrix2d() << 5, 5, 9, 9).finished()));
    }
    void theSizeFollowsTheItemsAndTheShape()
    {
        Eigen::MatrixXd wide = evenly(100, 2);
        wide.col(0) *= 3;
        const auto found = selfOrganizingMap(wide);
        // 5 sqrt(100) = 50 units, about three times as long as wide.
        QVERIFY(found->rows * found->columns >= 50 && found->rows * found->columns < 65);
        QVERIFY(found->columns >= 2 * found->rows && found->columns <= 4 * found->rows);
    }
    void stepsLeadFromTheStartToTheResult()
    {
        const auto found = selfOrganizingMap(zScores());
        QCOMPARE(int(found->steps.size()), found->iterations + 1);
        QVERIFY(found->steps.back().weights == found->weights);
        QCOMPARE(found->steps.back().quantizationError, found->quantizationError);
        QCOMPARE(found->steps.back().radius, 0.5);
        for (std::size_t s = 2; s < found->steps.size(); ++s)
            QVERIFY(found->steps[s].radius <= found->steps[s - 1].radius);
    }
    void moreStartsNeverDistortMore()
    {
        const Eigen::MatrixXd items = evenly(200, 3);
        SelfOrganizingMapOptions options = grid(6, 6);
        options.restarts = 1;
        const double one = selfOrganizingMap(items, options)->distortion;
        options.restarts = 8;
        const double eight = selfOrganizingMap(items, options)->distortion;
        QVERIFY(eight <= one);
    }
    void theSameSeedGivesTheSameMapAlsoOfALongTable()
    {
        const Eigen::MatrixXd items = evenly(25'000, 3); // ordered on a part, in several chunks
        SelfOrganizingMapOptions options = grid(5, 5, 4);
        options.restarts = 2;
        const auto one = selfOrganizingMap(items, options);
        const auto two = selfOrganizingMap(items, options);
        QVERIFY(one->weights == two->weights);
        QCOMPARE(one->labels, two->labels);
        QCOMPARE(int(one->labels.size()), 25'000);
        QCOMPARE(one->hits.size(), std::size_t(25));
    }
    void anyTableGivesFiniteNumbers_data()
    {
        QTest::addColumn<Eigen::MatrixXd>("items");
        QTest::addColumn<int>("groups");
        QTest::newRow("all the same") << Eigen::MatrixXd(Eigen::MatrixXd::Ones(10, 3)) << 1;
        Eigen::MatrixXd places(12, 3);
        for (int i = 0; i < 12; ++i)
            places.row(i).setConstant(i / 6);
        QTest::newRow("two places") << places << 2;
        QTest::newRow("three items") << evenly(3, 3) << 3;
        QTest::newRow("one feature") << evenly(30, 1) << 3;
        QTest::newRow("tiny") << Eigen::MatrixXd(evenly(30, 3) * 1e-300) << 3;
        QTest::newRow("huge") << Eigen::MatrixXd(evenly(30, 3) * 1e150) << 3;
    }
    void anyTableGivesFiniteNumbers()
    {
        QFETCH(Eigen::MatrixXd, items);
        QFETCH(int, groups);
        SelfOrganizingMapOptions options;
        options.groups = std::min(3, int(items.rows()));
        options.restarts = 2;
        const auto found = selfOrganizingMap(items, options);
        QVERIFY(found->weights.allFinite() && found->centroids.allFinite());
        QVERIFY(std::isfinite(found->quantizationError) && std::isfinite(found->distortion));
        QCOMPARE(int(found->centroids.rows()), groups); // no more than there are places
        QCOMPARE(int(found->labels.size()), int(items.rows()));
        QVERIFY(found->uMatrix().allFinite());
    }
    void badOptionsAndNumbersAreErrors()
    {
        const Eigen::MatrixXd items = evenly(50, 2);
        for (const SelfOrganizingMapOptions& options :
             {grid(-1, 3), grid(3, -1), grid(100, 100), grid(2, 2, 5), grid(2, 2, 0), grid(0, 0, 2000)})
            QCOMPARE(selfOrganizingMap(items, options).error().code, ErrorCode::Usage);
        SelfOrganizingMapOptions none;
        none.restarts = 0;
        QCOMPARE(selfOrganizingMap(items, none).error().code, ErrorCode::Usage);
        QCOMPARE(selfOrganizingMap(Eigen::MatrixXd::Constant(9, 2, std::nan(""))).error().code,
                 ErrorCode::BadInput);
        QVERIFY(selfOrganizingMap(items.topRows(3))->status == SelfOrganizingMapStatus::TooFewItems);
    }
};

GRIPSCOPE_TEST(SelfOrganizingMapTest)
#include "self_organizing_map_test.moc"
