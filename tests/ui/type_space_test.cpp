// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/models/cluster_table_model.h"
#include "ui/models/type_space.h"
#include "ui/scene/type_scene.h"

#include <QAbstractItemModelTester>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace gripscope;

class TypeSpaceTest : public QObject {
    Q_OBJECT
private slots:
    void thePaperHasFourTypesOfTen()
    {
        const TypeSpace space = paperTypeSpace();
        QCOMPARE(space.types, (QStringList{QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C"),
                                           QStringLiteral("D")}));
        QCOMPARE(space.counts, (std::vector<int>{10, 10, 10, 10}));
        QCOMPARE(space.squeezes[13].id, QStringLiteral("B 4"));
        QCOMPARE(space.units.m, QStringLiteral("1"));
        QVERIFY(space.nearest && space.nearest->distance > 4);
        for (const auto& ellipsoid : space.ellipsoids)
            QVERIFY(ellipsoid);
    }
    void anExampleLibraryIsTheSameSpaceInSi()
    {
        QTemporaryDir folder;
        const auto library = Library::open(folder.filePath(QStringLiteral("library.db")));
        QVERIFY(library);
        QVERIFY((*library)->loadExampleTypes());
        const Expected<TypeSpace> space = libraryTypeSpace(**library);
        QVERIFY(space);
        QCOMPARE(space->types.size(), 4);
        QCOMPARE(space->squeezes.size(), std::size_t(40));
        QCOMPARE(space->units.k, QStringLiteral("N/m"));
        // A change of the unit of time scales m, b and k: distances in their logarithms stay.
        QVERIFY(std::abs(space->nearest->distance - paperTypeSpace().nearest->distance) < 1e-6);
    }
    void clustersAreTheTypesInEveryScaling_data()
    {
        QTest::addColumn<int>("scaling");
        QTest::addColumn<double>("inertia");
        // Published optima for 40 rows; the raw and log ones to 9 digits.
        QTest::newRow("none") << int(FeatureScaling::None) << 0.0011127767646;
        QTest::newRow("zscore") << int(FeatureScaling::ZScore) << 3.14528774528;
        QTest::newRow("log") << int(FeatureScaling::Log) << 0.161962421918;
    }
    void clustersAreTheTypesInEveryScaling()
    {
        QFETCH(int, scaling);
        QFETCH(double, inertia);
        const Expected<SpaceClustering> found = clusterTypeSpace(paperTypeSpace(), FeatureScaling(scaling));
        QVERIFY(found);
        QCOMPARE(found->agreement.adjustedRandIndex, 1.0);
        QVERIFY(std::abs(found->result.inertia / inertia - 1) < 1e-9);
        QCOMPARE(found->centroids.size(), found->result.steps.size());
        QCOMPARE(found->table.size(), std::size_t(10));
        // The centroids are those of the space: inside the range of its points.
        const auto& last = found->centroids.back();
        QVERIFY(last.col(0).minCoeff() > 0.02 && last.col(0).maxCoeff() < 0.05);
    }
    void aRandomStartMayEndElsewhere()
    {
        bool elsewhere = false;
        for (int start = 1; start <= 9; ++start) {
            const auto found = clusterTypeSpace(paperTypeSpace(), FeatureScaling::None, start);
            QVERIFY(found);
            QVERIFY(found->result.inertia > 0.00111277676);
            elsewhere = elsewhere || found->agreement.adjustedRandIndex < 0.9;
        }
        QVERIFY(elsewhere); // one start in two misses the optimum on raw values
    }
    void oneTypeHasNoClusters()
    {
        TypeSpace space = paperTypeSpace();
        space.types = {QStringLiteral("A")};
        space.squeezes.resize(10);
        QVERIFY(!clusterTypeSpace(space, FeatureScaling::ZScore));
    }
    void hidingATypeMovesNothing()
    {
        const TypeSpace space = paperTypeSpace();
        const SceneContent all = typeScene(space, {true, true, true, true}, std::nullopt);
        const SceneContent some = typeScene(space, {true, false, true, true}, std::nullopt);
        QCOMPARE(all.points.size(), std::size_t(40));
        QCOMPARE(some.points.size(), std::size_t(30));
        QCOMPARE(some.ellipsoids.size(), std::size_t(3));
        for (std::size_t axis = 0; axis < 3; ++axis)
            QCOMPARE(some.axes[axis].low, all.axes[axis].low);
        QCOMPARE(all.axes[0].title(), QStringLiteral("Mass m (as printed)"));
    }
    void eachStepColoursByItsOwnClusters()
    {
        const TypeSpace space = paperTypeSpace();
        const auto found = clusterTypeSpace(space, FeatureScaling::None, 2);
        QVERIFY(found && found->result.steps.size() >= 2);
        const int last = int(found->result.steps.size()) - 1;
        const SceneContent content = clusterScene(space, {true, true, true, true}, *found, last);
        for (std::size_t i = 0; i < content.points.size(); ++i)
            QCOMPARE(content.points[i].color, found->result.labels[i]);
        QCOMPARE(content.centroids.size(), std::size_t(4));
        QCOMPARE(int(content.centroids[0].trail.size()), last + 1);
        QVERIFY(content.ellipsoids.empty());
    }
    void tableOneKeepsTheRulesOfAModel()
    {
        const auto found = clusterTypeSpace(paperTypeSpace(), FeatureScaling::ZScore);
        ClusterTableModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setTable(found->agreement.truths, found->table);
        QCOMPARE(model.rowCount(), 10);
        QCOMPARE(model.columnCount(), 4);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 10; ++row)
                QCOMPARE(model.index(row, column).data(ClusterTableModel::SortRole).toInt(), column + 1);
        QCOMPARE(model.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("C"));
    }
};

GRIPSCOPE_TEST(TypeSpaceTest)
#include "type_space_test.moc"
