// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/work_watch.h"
#include "tests/support/test_registry.h"
#include "ui/charts/heat_map.h"
#include "ui/models/cluster_models.h"
#include "ui/models/space_clustering.h"
#include "ui/scene/type_scene.h"

#include <QAbstractItemModelTester>
#include <QTest>

#include <cmath>
#include <numeric>

using namespace gripscope;
using namespace Qt::StringLiterals;

Q_DECLARE_METATYPE(gripscope::ClusterMethod)
Q_DECLARE_METATYPE(gripscope::MixtureCovariance)

namespace {

const TypeVisibility all{true, true, true, true};

SpaceClustering found(const TypeSpace& space, const ClusterRequest& request)
{
    Expected<SpaceClustering> clustering = clusterTypeSpace(space, request);
    if (!clustering)
        qFatal("%s", qPrintable(clustering.error().describe()));
    return *clustering;
}

SpaceClustering paperBy(ClusterMethod method)
{
    ClusterRequest request;
    request.method = method;
    return found(paperTypeSpace(), request);
}

/// The paper's squeezes, every one the same.
TypeSpace copies()
{
    TypeSpace space = paperTypeSpace();
    for (SpaceSqueeze& squeeze : space.squeezes)
        squeeze.parameters = space.squeezes[0].parameters;
    return space;
}

} // namespace

class SpaceClusteringTest : public QObject {
    Q_OBJECT
private slots:
    void kMeansReachesThePublishedOptimum_data()
    {
        QTest::addColumn<int>("scaling");
        QTest::addColumn<double>("inertia");
        // Published optima for 40 rows; the raw and log ones to 9 digits.
        QTest::newRow("none") << int(FeatureScaling::None) << 0.0011127767646;
        QTest::newRow("zscore") << int(FeatureScaling::ZScore) << 3.14528774528;
        QTest::newRow("log") << int(FeatureScaling::Log) << 0.161962421918;
    }
    void kMeansReachesThePublishedOptimum()
    {
        QFETCH(int, scaling);
        QFETCH(double, inertia);
        ClusterRequest request;
        request.scaling = FeatureScaling(scaling);
        const SpaceClustering clustering = found(paperTypeSpace(), request);
        QCOMPARE(*clustering.randIndex, 1.0);
        QVERIFY(std::abs(clustering.outcome.inertia / inertia - 1) < 1e-9);
        QCOMPARE(clustering.table.size(), std::size_t(10));
        // The centres are those of the space: inside the range of its points.
        const Eigen::MatrixXd last = clustering.centres(clustering.states() - 1);
        QVERIFY(last.col(0).minCoeff() > 0.02 && last.col(0).maxCoeff() < 0.05);
    }
    void everyMethodFindsTheTypesAndHasItsOwnPicture_data()
    {
        QTest::addColumn<ClusterMethod>("method");
        QTest::addColumn<MixtureCovariance>("covariance");
        QTest::newRow("K-means") << ClusterMethod::KMeans << MixtureCovariance::Full;
        QTest::newRow("tied") << ClusterMethod::GaussianMixture << MixtureCovariance::Tied;
        QTest::newRow("full") << ClusterMethod::GaussianMixture << MixtureCovariance::Full;
        QTest::newRow("map") << ClusterMethod::SelfOrganizingMap << MixtureCovariance::Full;
    }
    void everyMethodFindsTheTypesAndHasItsOwnPicture()
    {
        QFETCH(ClusterMethod, method);
        QFETCH(MixtureCovariance, covariance);
        const TypeSpace space = paperTypeSpace();
        for (const FeatureScaling scaling :
             {FeatureScaling::None, FeatureScaling::ZScore, FeatureScaling::Log, FeatureScaling::ZLog}) {
            ClusterRequest request = clusterRequest(space);
            request.method = method;
            request.covariance = covariance;
            request.scaling = scaling;
            const SpaceClustering clustering = found(space, request);
            QCOMPARE(*clustering.randIndex, 1.0);
            QVERIFY(clustering.remark().isEmpty());
            QVERIFY(clustering.states() >= 2);
            for (int state = 0; state < clustering.states(); ++state) {
                const SceneContent content = clusterScene(space, all, clustering, state);
                QCOMPARE(content.points.size(), std::size_t(40));
                const bool map = method == ClusterMethod::SelfOrganizingMap;
                QCOMPARE(content.centroids.size(), std::size_t(map ? 0 : 4));
                QCOMPARE(content.net.has_value(), map);
                QCOMPARE(content.ellipsoids.size(),
                         std::size_t(method == ClusterMethod::GaussianMixture ? 4 : 0));
                QVERIFY(!clustering.figure(state).isEmpty());
            }
        }
    }
    void aTrailGrowsByOneAState()
    {
        ClusterRequest request;
        request.scaling = FeatureScaling::None;
        request.restarts = request.candidates = 1;
        request.seed = 2;
        const TypeSpace space = paperTypeSpace();
        const SpaceClustering clustering = found(space, request);
        for (int state = 0; state < clustering.states(); ++state) {
            const SceneContent content = clusterScene(space, all, clustering, state);
            QCOMPARE(int(content.centroids[0].trail.size()), state + 1);
            for (std::size_t i = 0; i < content.points.size(); ++i)
                QCOMPARE(content.points[i].color, clustering.labels(state)[i]);
        }
    }
    void aSingleRandomStartMayEndElsewhere()
    {
        bool elsewhere = false;
        for (std::uint64_t start = 1; start <= 9; ++start) {
            ClusterRequest request;
            request.scaling = FeatureScaling::None;
            request.restarts = request.candidates = 1;
            request.seed = start;
            elsewhere = elsewhere || *found(paperTypeSpace(), request).randIndex < 0.9;
        }
        QVERIFY(elsewhere); // one start in two misses the optimum on raw values
    }
    void theEllipsoidOfATiedMixtureHoldsItsShare()
    {
        // 40 squeezes, 95 %: 2 are expected outside, more than 6 have a probability of 0.4 %.
        ClusterRequest request;
        request.method = ClusterMethod::GaussianMixture;
        request.covariance = MixtureCovariance::Tied;
        const TypeSpace space = paperTypeSpace();
        const SpaceClustering clustering = found(space, request);
        const int last = clustering.states() - 1;
        const auto ellipsoids = clustering.ellipsoids(last);
        int outside = 0;
        for (std::size_t i = 0; i < space.squeezes.size(); ++i) {
            const Ellipsoid& own = *ellipsoids[std::size_t(clustering.labels(last)[i])];
            const Eigen::Vector3d along =
                own.axes.transpose() * (space.squeezes[i].parameters.vector() - own.centre);
            outside += along.cwiseQuotient(own.radii).squaredNorm() > 1 ? 1 : 0;
        }
        QVERIFY2(outside <= 6, qPrintable(QString::number(outside)));
    }
    void theNetHasItsEdgesAndEndsAmongThePoints()
    {
        const TypeSpace space = paperTypeSpace();
        const SpaceClustering clustering = paperBy(ClusterMethod::SelfOrganizingMap);
        const auto& map = std::get<SelfOrganizingMapResult>(clustering.outcome.details);
        const SceneContent content = clusterScene(space, all, clustering, clustering.states() - 1);
        QCOMPARE(int(content.net->nodes.size()), map.rows * map.columns);
        QCOMPARE(int(content.net->edges.size()), map.rows * (map.columns - 1) + map.columns * (map.rows - 1));
        // A weight is a mean of squeezes: it cannot leave their box. The start can.
        const auto bounds = contentBounds(typeScene(space, all, std::nullopt));
        for (const Eigen::Vector3d& node : content.net->nodes)
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(node[axis] >= bounds(axis, 0) && node[axis] <= bounds(axis, 1));
        // The axes hold it in every state.
        for (int state = 0; state < clustering.states(); ++state) {
            const SceneContent then = clusterScene(space, all, clustering, state);
            for (const Eigen::Vector3d& node : then.net->nodes)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double at = then.axes[axis].unitPosition(node[Eigen::Index(axis)]);
                    QVERIFY2(at > -1e-6 && at < 1 + 1e-6, qPrintable(QString::number(at)));
                }
        }
    }
    void planesOfAMapAreItsNumbersInUnits()
    {
        const TypeSpace space = paperTypeSpace();
        const SpaceClustering clustering = paperBy(ClusterMethod::SelfOrganizingMap);
        const MapPlanes map = mapPlanes(space, clustering);
        QCOMPARE(map.planes.size(), std::size_t(4));
        QCOMPARE(std::accumulate(map.hits.begin(), map.hits.end(), 0), 40);
        const Eigen::MatrixXd weights = clustering.weights(clustering.states() - 1);
        for (int unit = 0; unit < map.rows * map.columns; ++unit)
            for (int feature = 0; feature < 3; ++feature)
                QCOMPARE(map.planes[std::size_t(feature) + 1].values(unit / map.columns, unit % map.columns),
                         weights(unit, feature));
        for (const MapPlane& plane : map.planes) {
            QCOMPARE(plane.scale.low, plane.values.minCoeff());
            QCOMPARE(plane.scale.high, plane.values.maxCoeff());
        }
        // Borders between clusters are where neighbours are far apart.
        const auto busy = std::max_element(map.hits.begin(), map.hits.end()) - map.hits.begin();
        QVERIFY(map.describe(int(busy), 3).contains(u"Stiffness k"_s));
        QVERIFY(map.describe(int(busy), 3).contains(u" of "_s));
        QVERIFY(map.describe(-1, 0).isEmpty());
        QVERIFY(mapPlanes(space, paperBy(ClusterMethod::KMeans)).planes.empty());
    }
    void whatCannotBeGroupedIsSaidInWords()
    {
        TypeSpace space = paperTypeSpace();
        ClusterRequest request;
        request.clusters = 41;
        auto refused = clusterTypeSpace(space, request);
        QVERIFY(!refused);
        QVERIFY(
            refused.error().describe().contains(u"41 clusters need at least 41 squeezes; there are 40"_s));
        space.squeezes.resize(1);
        refused = clusterTypeSpace(space, clusterRequest(space));
        QVERIFY(!refused && refused.error().describe().contains(u"at least two squeezes"_s));
        QVERIFY(!adviseTypeSpace(space, FeatureScaling::ZScore));
    }
    void squeezesThatAreAllAlikeAreOneCluster()
    {
        for (const ClusterMethod method :
             {ClusterMethod::KMeans, ClusterMethod::GaussianMixture, ClusterMethod::SelfOrganizingMap}) {
            ClusterRequest request;
            request.method = method;
            const SpaceClustering clustering = found(copies(), request);
            QVERIFY2(clustering.remark().contains(u"one cluster"_s), qPrintable(clustering.remark()));
            const SceneContent content = clusterScene(copies(), all, clustering, clustering.states() - 1);
            QVERIFY(contentBounds(content).allFinite());
        }
        const auto advice = adviseTypeSpace(copies(), FeatureScaling::ZScore);
        QVERIFY(advice);
        QCOMPARE(advice->clusters, 1);
    }
    void oneTypeHasClustersButNothingToAgreeWith()
    {
        TypeSpace space = paperTypeSpace();
        space.types = {u"A"_s};
        space.squeezes.resize(10);
        space.counts = {10};
        const SpaceClustering clustering = found(space, clusterRequest(space));
        QCOMPARE(clustering.outcome.request.clusters, 2);
        QVERIFY(!clustering.randIndex);
    }
    void workCanBeStopped()
    {
        const auto watch = std::make_shared<WorkWatch>();
        watch->stop();
        for (const ClusterMethod method :
             {ClusterMethod::KMeans, ClusterMethod::GaussianMixture, ClusterMethod::SelfOrganizingMap}) {
            ClusterRequest request;
            request.method = method;
            request.watch = watch;
            const auto stopped = clusterTypeSpace(paperTypeSpace(), request);
            QVERIFY(!stopped);
            QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
        }
        const auto stopped = adviseTypeSpace(paperTypeSpace(), FeatureScaling::ZScore, watch);
        QVERIFY(!stopped);
        QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
    }
    void adviceOnThePaperIsFourAndSaysWhy()
    {
        const auto watch = std::make_shared<WorkWatch>();
        const auto advice = adviseTypeSpace(paperTypeSpace(), FeatureScaling::ZScore, watch);
        QVERIFY(advice);
        QCOMPARE(watch->share(), 1.0);
        QCOMPARE(advice->clusters, 4); // science: silhouette, Calinski-Harabasz and Davies-Bouldin say 4
        AdviceTableModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setAdvice(*advice);
        QCOMPARE(model.rowCount(), 8);
        for (const auto column :
             {AdviceTableModel::Column::Clusters, AdviceTableModel::Column::Silhouette,
              AdviceTableModel::Column::CalinskiHarabasz, AdviceTableModel::Column::DaviesBouldin})
            for (int row = 0; row < 8; ++row) {
                const QModelIndex cell = model.index(row, int(column));
                QCOMPARE(cell.data(AdviceTableModel::BestRole).toBool(), row == 3);
                QCOMPARE(cell.data(Qt::FontRole).value<QFont>().bold(), row == 3);
            }
        QCOMPARE(model.index(0, int(AdviceTableModel::Column::Silhouette)).data().toString(),
                 QString(QChar(0x2013))); // one cluster has none
        QCOMPARE(model.toTsv().count(u'\n'), 9);
    }
    void longTypesAreCountedInsteadOfListed()
    {
        TypeSpace space = paperTypeSpace();
        const std::vector<SpaceSqueeze> once = space.squeezes;
        space.squeezes.insert(space.squeezes.end(), once.begin(), once.end());
        space.counts = {20, 20, 20, 20};
        const SpaceClustering clustering = found(space, {});
        QVERIFY(clustering.table.empty());
        ClusterCountsModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setAgreement(clustering.agreement);
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.columnCount(), 4);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                QCOMPARE(model.index(row, column).data(ClusterCountsModel::SortRole).toInt(),
                         row == column ? 20 : 0);
        QCOMPARE(model.headerData(1, Qt::Vertical, Qt::DisplayRole).toString(), u"B"_s);
    }
    void tableOneKeepsTheRulesOfAModel()
    {
        const SpaceClustering clustering = paperBy(ClusterMethod::KMeans);
        ClusterTableModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setTable(clustering.agreement.truths, clustering.table);
        QCOMPARE(model.rowCount(), 10);
        QCOMPARE(model.columnCount(), 4);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 10; ++row)
                QCOMPARE(model.index(row, column).data(ClusterTableModel::SortRole).toInt(), column + 1);
        QCOMPARE(model.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("C"));
    }
};

GRIPSCOPE_TEST(SpaceClusteringTest)
#include "space_clustering_test.moc"
