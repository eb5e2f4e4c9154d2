// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/quality/gauge_tables.h"
#include "tests/support/test_registry.h"

#include <Eigen/LU>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// Three values whose effects are drawn apart from each other.
GaugeMeasurements threeValues(double missing = 0, int parts = 10)
{
    std::vector<GaugeRow> rows =
        thinned(drawnCrossedRows(parts, 3, 0, 3, {2, 0.3, 0, 0.2, 0, 0.4}, 21), missing, 2);
    GaugeMeasurements measurements = measurementsOf(rows);
    measurements.names = QStringList{u"m"_s, u"b"_s, u"k"_s};
    measurements.values.conservativeResize(Eigen::NoChange, 3);
    for (int j = 1; j < 3; ++j) {
        drawGaugeValues(rows, {2.0 * j, 0.3, 0, 0.2, 0, 0.6}, 21 + std::uint64_t(j));
        measurements.values.col(j) = valuesOf(rows);
    }
    return measurements;
}

} // namespace

class JointGaugeTest : public QObject {
    Q_OBJECT
private slots:
    void oneValueIsWheelersRatio()
    {
        const GaugeMeasurements one = measurementsOf(manualRows());
        GaugeLayout layout = gaugeLayout(one.factors).value();
        const SourceSums sums = sourceSums(layout, one.values).value();
        const Eigen::VectorXd variances = sums.momentVariances().cwiseMax(0);
        const double ratio = variances[0] / (variances.sum() - variances[0]);
        QVERIFY(isRelativelyNear(jointGauge(sums)->kinds, std::sqrt(1 + 2 * ratio), 1e-10));
    }
    void kindsMultiplyWhereValuesAreIndependent()
    {
        const GaugeMeasurements measurements = threeValues(0, 100);
        GaugeOptions options;
        options.pooling = false;
        const GaugeStudy study = studyGauge(measurements, options).value();
        double product = 1;
        for (const GaugeValue& value : study.values) {
            const double categories = *value.distinctCategories;
            product *= std::sqrt(1 + categories * categories);
        }
        // Nearly: a hundred parts leave chance correlations.
        QVERIFY2(study.joint->kinds > 0.85 * product && study.joint->kinds < 1.15 * product,
                 qPrintable(u"%1 of %2"_s.arg(study.joint->kinds).arg(product)));
        for (const JointDirection& direction : study.joint->directions)
            QVERIFY(direction.kinds >= 1);
        QVERIFY(english(study.jointMessages).first().contains(u"Together the values tell"_s));
    }
    /// Any other coordinates of the same space tell as many apart: sums, differences, units.
    void coordinatesDoNotMatter()
    {
        for (const double missing : {0.0, 0.2}) {
            GaugeMeasurements measurements = threeValues(missing);
            const JointGauge before = *studyGauge(measurements)->joint;
            Eigen::Matrix3d other;
            other << 1e-3, 2e-3, 0, 0, 1, -1, 5e-4, 0, 1000;
            measurements.values = measurements.values * other;
            const JointGauge after = *studyGauge(measurements)->joint;
            QVERIFY2(isRelativelyNear(after.kinds, before.kinds, 1e-6),
                     qPrintable(u"%1 %2"_s.arg(after.kinds).arg(before.kinds)));
            const double determinants =
                std::sqrt((before.gauge + 2 * before.part).determinant() / before.gauge.determinant());
            QVERIFY(isRelativelyNear(before.kinds, determinants, 1e-8));
        }
    }
    void aValueThatTellsNothingTakesNothingAway()
    {
        GaugeMeasurements measurements = threeValues();
        GaugeMeasurements two = measurements;
        two.names.removeLast();
        two.values = measurements.values.leftCols(2).eval();
        std::vector<GaugeRow> noise = drawnCrossedRows(10, 3, 0, 3, {0, 0, 0, 0, 0, 1}, 99);
        measurements.values.col(2) = valuesOf(noise);
        const double with = studyGauge(measurements)->joint->kinds, without = studyGauge(two)->joint->kinds;
        QVERIFY2(with > 0.9 * without && with < 1.5 * without, qPrintable(u"%1 %2"_s.arg(with).arg(without)));
    }
    void aValueThatOthersDetermineIsSaid()
    {
        GaugeMeasurements measurements = threeValues();
        measurements.values.col(2) = measurements.values.col(0) - 2 * measurements.values.col(1);
        const GaugeStudy study = studyGauge(measurements).value();
        QVERIFY(!study.joint);
        QVERIFY(english(study.jointMessages).first().contains(u"cannot be judged together"_s));
    }
};

GRIPSCOPE_TEST(JointGaugeTest)
#include "joint_gauge_test.moc"
