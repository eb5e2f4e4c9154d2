// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_agreement.h"
#include "core/clustering/cluster_method.h"
#include "core/clustering/feature_scaling.h"
#include "core/clustering/kmeans.h"
#include "core/recognition/types/paper_appendix.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

Q_DECLARE_METATYPE(gripscope::ClusterMethod)

class ClusterMethodTest : public QObject {
    Q_OBJECT
private slots:
    void everyMethodFindsTable1InEveryScaling_data()
    {
        QTest::addColumn<ClusterMethod>("method");
        QTest::addColumn<FeatureScaling>("scaling");
        for (const ClusterMethod method :
             {ClusterMethod::KMeans, ClusterMethod::SelfOrganizingMap, ClusterMethod::GaussianMixture})
            for (const FeatureScaling scaling :
                 {FeatureScaling::None, FeatureScaling::ZScore, FeatureScaling::Log, FeatureScaling::ZLog})
                QTest::addRow("%s, %s", qPrintable(toString(method)), qPrintable(toString(scaling)))
                    << method << scaling;
    }
    void everyMethodFindsTable1InEveryScaling()
    {
        QFETCH(ClusterMethod, method);
        QFETCH(FeatureScaling, scaling);
        ClusterRequest request;
        request.method = method;
        request.scaling = scaling;
        const auto found = groupRows(paperAppendix().parameters, request);
        QVERIFY(found->converged);
        QCOMPARE(clusterAgreement(paperAppendix().object, found->labels, 4).adjustedRandIndex, 1.0);
        // The right groups have the least inertia of all (science: the optimum has the true groups), and the
        // means of the groups give it; the mixture's means are those to within its overlap, which is nothing.
        request.method = ClusterMethod::KMeans;
        const auto optimum = groupRows(paperAppendix().parameters, request);
        QVERIFY(std::abs(found->inertia / optimum->inertia - 1) < 1e-3);
        QVERIFY((found->centroids - optimum->centroids).cwiseAbs().maxCoeff() < 1e-3);
    }
    void theDocumentHoldsWhatTheContractNames()
    {
        ClusterRequest request;
        request.method = ClusterMethod::SelfOrganizingMap;
        const auto found = groupRows(paperAppendix().parameters, request);
        const auto agreement = clusterAgreement(paperAppendix().object, found->labels, 4);
        const QJsonObject document = clusterJson(*found, {u"m"_s, u"b"_s, u"k"_s}, agreement);
        for (const QString& member : {u"method"_s, u"labels"_s, u"centroids"_s, u"inertia"_s, u"iterations"_s,
                                      u"adjusted_rand_index"_s, u"confusion"_s})
            QVERIFY2(document.contains(member), qPrintable(member));
        const QJsonObject map = document[u"map"_s].toObject();
        const int rows = map[u"rows"_s].toInt();
        const int columns = map[u"columns"_s].toInt();
        int items = 0;
        for (const QJsonValue& row : map[u"hits"_s].toArray())
            for (const QJsonValue& hits : row.toArray())
                items += hits.toInt();
        QCOMPARE(items, 40);
        for (const QString& plane : {u"m"_s, u"b"_s, u"k"_s}) {
            const QJsonArray values = map[u"component_planes"_s][plane].toArray();
            QCOMPARE(values.size(), rows);
            QCOMPARE(values[0].toArray().size(), columns);
            // In the table's own units: the paper's numbers are all between 0 and 1, z-scores are not.
            for (const QJsonValue& row : values)
                for (const QJsonValue& value : row.toArray())
                    QVERIFY(value.toDouble() > 0 && value.toDouble() < 0.2);
        }
    }
    void withoutTruthAgreementIsNull()
    {
        const auto found = groupRows(paperAppendix().parameters, {});
        const QJsonObject document = clusterJson(*found, {u"m"_s, u"b"_s, u"k"_s});
        QVERIFY(document[u"adjusted_rand_index"_s].isNull() && document[u"confusion"_s].isNull());
        QVERIFY(!document.contains(u"advice"_s));
    }
    void badTablesAreErrors()
    {
        for (const ClusterMethod method :
             {ClusterMethod::KMeans, ClusterMethod::SelfOrganizingMap, ClusterMethod::GaussianMixture}) {
            ClusterRequest request;
            request.method = method;
            QCOMPARE(groupRows(Eigen::MatrixXd::Ones(3, 3), request).error().code, ErrorCode::BadInput);
            QCOMPARE(groupRows(Eigen::MatrixXd::Constant(9, 3, std::nan("")), request).error().code,
                     ErrorCode::BadInput);
            request.scaling = FeatureScaling::Log;
            QCOMPARE(groupRows(Eigen::MatrixXd::Zero(9, 3), request).error().code, ErrorCode::BadInput);
        }
    }
};

GRIPSCOPE_TEST(ClusterMethodTest)
#include "cluster_method_test.moc"
