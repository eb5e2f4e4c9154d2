// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/feature_scaling.h"
#include "core/recognition/types/paper_appendix.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

class FeatureScalingTest : public QObject {
    Q_OBJECT
private slots:
    void zscoresHaveMeanZeroAndPopulationDeviationOne()
    {
        for (FeatureScaling scaling : {FeatureScaling::ZScore, FeatureScaling::ZLog}) {
            const Eigen::MatrixXd& x = paperAppendix().parameters;
            const Eigen::MatrixXd z = featureTransform(x, scaling)->apply(x);
            for (int j = 0; j < 3; ++j) {
                QVERIFY(std::abs(z.col(j).mean()) < 1e-13); // rounding of 40 numbers of size 1
                QVERIFY(std::abs(z.col(j).squaredNorm() / 40 - 1) < 1e-13);
            }
        }
    }
    void undoTakesItBack()
    {
        const Eigen::MatrixXd& x = paperAppendix().parameters;
        for (FeatureScaling scaling : all) {
            const auto transform = featureTransform(x, scaling);
            const Eigen::MatrixXd back = transform->undo(transform->apply(x));
            QVERIFY(((back - x).array() / x.array()).abs().maxCoeff() < 1e-14);
        }
    }
    void noneLeavesEveryBit()
    {
        const Eigen::MatrixXd& x = paperAppendix().parameters;
        QVERIFY(featureTransform(x, FeatureScaling::None)->apply(x) == x);
    }
    void aColumnWithoutSpreadKeepsItsScale()
    {
        Eigen::MatrixXd x(3, 2);
        x << 0.1, 1, 0.1, 2, 0.1, 3;
        const auto transform = featureTransform(x, FeatureScaling::ZScore);
        QCOMPARE(transform->scale(0), 1.0);
        QVERIFY(transform->apply(x).col(0).cwiseAbs().maxCoeff() < 1e-15);
    }
    void whatCannotBeScaledIsAnError()
    {
        Eigen::MatrixXd x(2, 1);
        x << 1, 0;
        QCOMPARE(featureTransform(x, FeatureScaling::Log).error().code, ErrorCode::BadInput);
        QVERIFY(featureTransform(x, FeatureScaling::ZScore).has_value());
        x << 1, std::nan("");
        QCOMPARE(featureTransform(x, FeatureScaling::None).error().code, ErrorCode::BadInput);
        Eigen::MatrixXd wide(5, 1);
        wide << 1.7e308, 1.7e308, 1.7e308, 1.7e308, -1.7e308; // even the distance from the mean overflows
        QCOMPARE(featureTransform(wide, FeatureScaling::ZScore).error().code, ErrorCode::BadInput);
    }
    void numbersWhoseSquaresVanishOrOverflowAreScaledToo()
    {
        const Eigen::MatrixXd x = Eigen::Vector4d(1, 2, 4, 5);
        const Eigen::MatrixXd wanted = featureTransform(x, FeatureScaling::ZScore)->apply(x);
        for (const double unit : {1e-300, 1e-200, 1e200, 1e307}) {
            const Eigen::MatrixXd y = x * unit;
            const Eigen::MatrixXd found = featureTransform(y, FeatureScaling::ZScore)->apply(y);
            QVERIFY((found - wanted).cwiseAbs().maxCoeff() < 1e-14); // a few roundings of numbers near 1
        }
    }

private:
    static constexpr FeatureScaling all[] = {FeatureScaling::None, FeatureScaling::ZScore,
                                             FeatureScaling::Log, FeatureScaling::ZLog};
};

GRIPSCOPE_TEST(FeatureScalingTest)
#include "feature_scaling_test.moc"
