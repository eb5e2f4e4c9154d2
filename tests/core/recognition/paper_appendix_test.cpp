// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/feature_scaling.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/research/paper_reproduction.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

class PaperAppendixTest : public QObject {
    Q_OBJECT
private slots:
    void holdsTenSqueezesOfEachOfFourCans()
    {
        const PaperAppendix& appendix = paperAppendix();
        QCOMPARE(appendix.parameters.rows(), 40);
        for (const QString& can : {u"A"_s, u"B"_s, u"C"_s, u"D"_s})
            QCOMPARE(appendix.object.count(can), 10);
        QCOMPARE(appendix.parameters(0, 0), 0.036819);
        QCOMPARE(appendix.parameters(39, 2), 0.083053);
        QCOMPARE(appendix.bestFitPercent.front(), 89.65);
    }
    void meansAndCovariancesAreTheOracles()
    {
        QFile file(QStringLiteral(GRIPSCOPE_TEST_DATA) + u"/kmeans_oracle.json"_s);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject oracle = QJsonDocument::fromJson(file.readAll()).object();
        for (int type = 0; type < 4; ++type) {
            const Eigen::MatrixXd x = paperAppendix().parameters.middleRows(10 * type, 10);
            const Eigen::RowVectorXd mean = x.colwise().mean();
            const Eigen::MatrixXd c = x.rowwise() - mean;
            const Eigen::MatrixXd covariance = c.transpose() * c / 9;
            for (int i = 0; i < 3; ++i) {
                QVERIFY(std::abs(mean(i) - oracle[u"means"_s][type][i].toDouble()) < 1e-15);
                for (int j = 0; j < 3; ++j) // entries of 1e-5 and less, rounded in their last place or two
                    QVERIFY(std::abs(covariance(i, j) - oracle[u"cov_n_minus_1"_s][type][i][j].toDouble()) <
                            1e-19);
            }
        }
    }
    void inSiCanAIsAPlausibleCan()
    {
        const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (int i = 0; i < 10; ++i)
            mean += squeezes[std::size_t(i)].parameters.vector() / 10;
        QVERIFY(std::abs(mean(0) - 0.0396) < 5e-5); // the digits that are stated
        QVERIFY(std::abs(mean(1) - 43.0) < 0.05);
        QVERIFY(std::abs(mean(2) - 9990) < 5);
        const double frequency = std::sqrt(mean(2) / mean(0)) / (2 * M_PI);
        QVERIFY(std::abs(frequency - 80) < 0.5);
    }
    void tableOneIsFourPureColumns()
    {
        const auto table = clusterPaperAppendix(FeatureScaling::ZScore).table1;
        QCOMPARE(table.size(), std::size_t(10));
        for (const std::vector<int>& row : table)
            QCOMPARE(row, std::vector<int>({1, 2, 3, 4}));
    }
    void theDocumentIsAsAgreed()
    {
        const QJsonObject document = reproducePaper();
        QCOMPARE(document.keys(), QStringList({u"best_fit"_s, u"leave_one_out_correct"_s, u"scalings"_s}));
        QCOMPARE(document[u"best_fit"_s].toObject(), (QJsonObject{{u"min"_s, 83.99}, {u"max"_s, 92.08}}));
        QCOMPARE(document[u"leave_one_out_correct"_s].toInt(), 40);
        const QJsonObject scalings = document[u"scalings"_s].toObject();
        QCOMPARE(scalings.keys(), QStringList({u"log"_s, u"none"_s, u"zlog"_s, u"zscore"_s}));
        for (const QJsonValue& scaling : scalings) {
            QCOMPARE(scaling.toObject().keys(),
                     QStringList({u"adjusted_rand_index"_s, u"inertia"_s, u"table1"_s}));
            QCOMPARE(scaling[u"adjusted_rand_index"_s].toDouble(), 1.0);
            QCOMPARE(scaling[u"table1"_s].toArray().size(), 10);
            QCOMPARE(scaling[u"table1"_s][0].toArray(), QJsonArray({1, 2, 3, 4}));
        }
    }
};

GRIPSCOPE_TEST(PaperAppendixTest)
#include "paper_appendix_test.moc"
