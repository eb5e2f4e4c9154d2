// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/predictive.h"
#include "core/recognition/verdict/judgement.h"
#include "tests/core/recognition/noisy_types.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr double deviation = 0.04;
const Eigen::Matrix3d alike = covarianceOf(deviation, deviation, deviation, 0);
const Eigen::Matrix3d scatterNoise = covarianceOf(0.02, 0.05, 0.01, 0.4);

/// How many of these enrolments see scatter that is alike, and the mean of what they take it for.
struct Seen {
    int alike = 0;
    double meanVariance = 0;
};

Seen enrol(const Eigen::Matrix3d& between, int squeezes, int enrolments)
{
    NoisyTypes source(11, between);
    Seen seen;
    for (int run = 0; run < enrolments; ++run) {
        const TypeModels models = fitTypeModels(source.enrolment(4, squeezes, scatterNoise));
        if (!models.scatter.alikeVariance)
            continue;
        seen.alike += 1;
        seen.meanVariance += *models.scatter.alikeVariance;
    }
    if (seen.alike > 0)
        seen.meanVariance /= seen.alike;
    return seen;
}

} // namespace

class AlikeScatterTest : public QObject {
    Q_OBJECT
private slots:
    void alikeScatterIsSeenUnderNoiseThatIsNot_data()
    {
        QTest::addColumn<int>("squeezes");
        QTest::newRow("3") << 3;
        QTest::newRow("10") << 10;
    }
    void alikeScatterIsSeenUnderNoiseThatIsNot()
    {
        QFETCH(int, squeezes);
        constexpr int enrolments = 400;
        const Seen seen = enrol(alike, squeezes, enrolments);
        // One in forty is stated to be taken for something else; 10 +- 3, and the least noisy direction alone
        // makes the likelihood lean on fewer than its degrees of freedom.
        QVERIFY2(seen.alike >= enrolments - 25, qPrintable(QString::number(seen.alike)));
        // Relative standard deviation of one: under sqrt(2 / (3 v)) (1 + C / S), 0.5 with 3 squeezes; of the
        // mean of 400 0.025. The floor at zero lifts it a little.
        const double ratio = seen.meanVariance / (deviation * deviation);
        QVERIFY2(std::abs(ratio - 1) < 0.1, qPrintable(QString::number(ratio)));
    }
    void scatterThatGoesTogetherIsSeenToBeUnlike()
    {
        QCOMPARE(enrol(covarianceOf(0.08, 0.08, 0.08, 0.95), 10, 100).alike, 0);
        QCOMPARE(enrol(covarianceOf(0.02, 0.04, 0.4, 0), 10, 100).alike, 0);
    }
    void squeezesThatScatterLessThanTheirNoiseGiveThatNoise()
    {
        NoisyTypes source(12, 1e-12 * alike);
        const TypeModels models = fitTypeModels(source.enrolment(4, 3, scatterNoise));
        QVERIFY(models.scatter.alikeVariance);
        QVERIFY(*models.scatter.alikeVariance > 0 && *models.scatter.alikeVariance < 0.01 * 0.01);
        const Eigen::Vector3d log = models.types[0].meanLog;
        for (const TypePrediction& prediction : predictTypes(models, log, scatterNoise, {})) {
            QVERIFY(prediction.alikeCovariance);
            QVERIFY((*prediction.alikeCovariance - prediction.covariance).norm() <
                    2 * prediction.covariance.norm());
        }
    }
    void copiesOfOneSqueezeAreNoTrouble()
    {
        std::vector<TypeSqueeze> copies;
        for (int i = 0; i < 12; ++i)
            copies.push_back({i % 2 ? u"A"_s : u"B"_s, {1, 2, i % 2 ? 3.0 : 4.0}});
        const TypeModels models = fitTypeModels(copies);
        QVERIFY(models.scatter.alikeVariance && *models.scatter.alikeVariance >= 1e-8);
        const auto predictions = predictTypes(models, models.types[0].meanLog, {}, {});
        const auto found = separation(predictions, 0, 1, models.types[0].meanLog, 0.01, false);
        QVERIFY(found && found->enough() && std::isfinite(found->reached));
        QVERIFY(!fitTypeModels({copies[0]}).scatter.alikeVariance);
    }
    void typesThatSpreadInTheirOwnWayAreNotHeldToOneShape()
    {
        NoisyTypes source(13, alike);
        const TypeModels models = fitTypeModels(source.enrolment(4, 3, scatterNoise));
        const Eigen::Vector3d log = models.types[0].meanLog;
        PredictionOptions robust;
        robust.robust = true;
        for (const TypePrediction& prediction : predictTypes(models, log, {}, robust))
            QVERIFY(!prediction.alikeCovariance);
    }
};

GRIPSCOPE_TEST(AlikeScatterTest)
#include "alike_scatter_test.moc"
