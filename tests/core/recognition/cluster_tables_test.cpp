// SPDX-License-Identifier: GPL-3.0-or-later
// Five tables against what scikit-learn found in them (tests/data/clusters/make_tables.py).
#include "core/clustering/cluster_advice.h"
#include "core/clustering/feature_table.h"
#include "core/clustering/kmeans.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

QString dataFile(const QString& name)
{
    return QStringLiteral(GRIPSCOPE_TEST_DATA) + u"/clusters/"_s + name;
}

QJsonObject peers()
{
    QFile file(dataFile(u"sklearn.json"_s));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

} // namespace

class ClusterTablesTest : public QObject {
    Q_OBJECT
private slots:
    void inertiaIsAtMostThatOfScikitLearn_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"blobs", "unequal_sizes", "elongated", "duplicates", "one_cluster"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void inertiaIsAtMostThatOfScikitLearn()
    {
        QFETCH(QString, name);
        const QJsonObject peer = peers()[u"tables"_s][name].toObject();
        const auto table = readFeatureTable(dataFile(name + u".csv"_s), {u"m"_s, u"b"_s, u"k"_s});
        QVERIFY(table.has_value());
        KMeansOptions options;
        options.clusters = peer[u"clusters"_s].toInt();
        options.restarts = peers()[u"restarts"_s].toInt();
        const auto found = kMeans(table->values, options);
        QVERIFY(found->status == KMeansStatus::Converged);
        const double wanted = peer[u"inertia"_s].toDouble();
        QVERIFY2(
            found->inertia <= wanted * (1 + 1e-9),
            qPrintable(u"%1, scikit-learn %2"_s.arg(found->inertia, 0, 'g', 15).arg(wanted, 0, 'g', 15)));
    }
    void theIndicesAreThoseOfScikitLearn_data() { inertiaIsAtMostThatOfScikitLearn_data(); }
    void theIndicesAreThoseOfScikitLearn()
    {
        QFETCH(QString, name);
        const QJsonObject peer = peers()[u"tables"_s][name].toObject();
        const auto table = readFeatureTable(dataFile(name + u".csv"_s), {u"m"_s, u"b"_s, u"k"_s});
        std::vector<int> labels;
        for (const QJsonValue& label : peer[u"labels"_s].toArray())
            labels.push_back(label.toInt());
        const auto agrees = [](std::optional<double> found, const QJsonValue& wanted) {
            // Some hundred sums of numbers near 1 in another order. The distances that scikit-learn takes
            // from |x|^2 + |y|^2 - 2 x y lose half their digits where two items almost coincide.
            return found && std::abs(*found - wanted.toDouble()) < 1e-8 * std::abs(wanted.toDouble());
        };
        QVERIFY(agrees(silhouette(table->values, labels), peer[u"silhouette"_s]));
        QVERIFY(agrees(calinskiHarabasz(table->values, labels), peer[u"calinski_harabasz"_s]));
        QVERIFY(agrees(daviesBouldin(table->values, labels), peer[u"davies_bouldin"_s]));
    }
};

GRIPSCOPE_TEST(ClusterTablesTest)
#include "cluster_tables_test.moc"
