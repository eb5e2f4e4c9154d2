// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_plan.h"
#include "core/calibration/sensor_calibration.h"
#include "core/calibration/sensor_correction.h"
#include "core/math/distributions.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// Reads 2 % too much and 0.1 N more coming down, up and down once.
SensorCalibration upAndDownOnce()
{
    SensorCalibration calibration;
    calibration.unit = u"N"_s;
    for (const double load : {0.0, 10.0, 20.0})
        calibration.points.push_back({load, 1.02 * load});
    for (const double load : {10.0, 0.0})
        calibration.points.push_back({load, 1.02 * load + 0.1});
    return calibration;
}

} // namespace

/// What a certificate says beside the curve.
class ConformityTest : public QObject {
    Q_OBJECT
private slots:
    void massesWeighByLocalGravity()
    {
        // 1 kg weighs g newtons, 1 lb 0.45359237 kg by definition.
        QVERIFY(!massPerNewton(LoadUnit::Channel, standardGravity));
        QCOMPARE(massPerNewton(LoadUnit::Kilogram, 9.81)->factor * 9.81, 1.0);
        QCOMPARE(massPerNewton(LoadUnit::Pound, standardGravity)->factor * 4.4482216152605, 1.0);
        QCOMPARE(massPerLoad(LoadUnit::Kilogram, 10, u"mN"_s)->factor * 10'000, 1.0);
        QVERIFY(!massPerLoad(LoadUnit::Kilogram, 10, u"counts"_s));
        QCOMPARE(massPerNewton(LoadUnit::Pound, 9.8)->unit, u"lb"_s);
    }
    void whatCannotBeIsSaid()
    {
        CalibrationConditions conditions;
        QVERIFY(!problemOf(conditions));
        conditions.ambient_C = 21.5;
        conditions.tolerance = 0.2;
        QVERIFY(!problemOf(conditions));
        for (const double wrong : {-21.0, 61.0, std::nan("")}) {
            CalibrationConditions other = conditions;
            other.ambient_C = wrong;
            QVERIFY(problemOf(other));
        }
        for (const double wrong : {0.0, -1.0, std::nan(""), double(INFINITY)}) {
            CalibrationConditions other = conditions;
            other.tolerance = wrong;
            QVERIFY(problemOf(other));
        }
        conditions.gravity = 1.62; // on the moon
        QVERIFY(problemOf(conditions));
    }
    void theUncertaintyIsCountedWhereTheRuleSaysSo()
    {
        using enum DecisionRule;
        QCOMPARE(judgeConformity(0.10, 0.05, 0.20, Guarded), CalibrationConformity::Conforms);
        QCOMPARE(judgeConformity(0.18, 0.05, 0.20, Guarded), CalibrationConformity::Undecided);
        QCOMPARE(judgeConformity(0.22, 0.05, 0.20, Guarded), CalibrationConformity::Undecided);
        QCOMPARE(judgeConformity(0.30, 0.05, 0.20, Guarded), CalibrationConformity::DoesNotConform);
        QCOMPARE(judgeConformity(0.18, 0.05, 0.20, Simple), CalibrationConformity::Conforms);
        QCOMPARE(judgeConformity(0.22, 0.05, 0.20, Simple), CalibrationConformity::DoesNotConform);
    }
    void asFoundIsByWhatCorrectedItBefore()
    {
        SensorCalibration calibration = upAndDownOnce();
        QVERIFY(!errorsAsFound(calibration)); // not recorded
        calibration.foundCorrection = u""_s;  // its own scale: 2 % of 20 N
        QVERIFY(std::abs(errorsAsFound(calibration)->largest - 0.4) < 1e-12);
        // With the right slope in force, what is left is the 0.1 N on the way down, as a load.
        const auto before = CalibrationCurve::fit({{0, 0}, {10, 10.2}, {20, 20.4}}, 1);
        QVERIFY(before);
        calibration.foundCorrection = SensorCorrection(*before).text();
        const auto found = errorsAsFound(calibration);
        QVERIFY(found && found->each.size() == 5);
        QVERIFY(std::abs(found->largest - 0.1 / 1.02) < 1e-9);
        QVERIFY(std::abs(found->each[1]) < 1e-9);
        calibration.foundCorrection = u"damaged"_s;
        QVERIFY(!errorsAsFound(calibration));
    }
    void asLeftIsByTheCheckWhereThereIsOne()
    {
        SensorCalibration calibration = upAndDownOnce();
        const auto evaluation = evaluateCalibration(calibration);
        QVERIFY(evaluation);
        const LoadErrors fitted = errorsAsLeft(calibration, *evaluation);
        QCOMPARE(fitted.each.size(), std::size_t(5));
        QVERIFY(fitted.largest < 0.1);
        calibration.checkPoints = {{15, 1.02 * 15 + 1}};
        const LoadErrors checked = errorsAsLeft(calibration, *evaluation);
        QCOMPARE(checked.each.size(), std::size_t(1));
        QVERIFY(checked.largest > 0.8);
    }
    void upAndDownAreMeansAtEachLoad()
    {
        const auto rows = upAndDown(upAndDownOnce().points);
        QCOMPARE(rows.size(), std::size_t(3));
        QVERIFY(std::abs(*rows[1].down - *rows[1].up - 0.1) < 1e-12);
        QVERIFY(rows[2].up && !rows[2].down); // at the top there is no way down yet
        QVERIFY(rows[0].up && rows[0].down);
    }
    void theCoverageFactorIsStudents()
    {
        GaussianNoise noise(3);
        SensorCalibration calibration = upAndDownOnce();
        calibration.points.clear();
        for (const double load : {0.0, 10.0, 20.0, 30.0, 40.0})
            calibration.points.push_back({load, 1.02 * load + 0.01 * noise()});
        const auto evaluation = evaluateCalibration(calibration);
        QVERIFY(evaluation);
        // Five points, two coefficients, nothing known from elsewhere: three degrees of freedom.
        QCOMPARE(evaluation->coverageFactor, studentQuantile(0.975, 3));
        calibration.reference.standardUncertainty = 10; // so much that the scatter is of no account
        QVERIFY(std::abs(evaluateCalibration(calibration)->coverageFactor - 1.96) < 1e-3);
    }
    void theCheckIsTheLastRunAndNoPartOfTheCurve()
    {
        CalibrationPlan plan;
        plan.loads = {0, 10, 20};
        plan.runs = 1;
        plan.checkAfter = true;
        const auto points = plannedPoints(plan);
        QCOMPARE(points.size(), std::size_t(9)); // 3 up, 2 down, 2 up, 2 down
        for (std::size_t i = 0; i < points.size(); ++i)
            QCOMPARE(points[i].check, i >= 5);
        plan.degree = 2;
        plan.descending = false; // three points for a parabola: the check cannot help
        QVERIFY(problemOf(plan));
        plan.conditions.ambient_C = 500;
        plan.descending = true;
        QVERIFY(problemOf(plan));
    }
};

GRIPSCOPE_TEST(ConformityTest)
#include "conformity_test.moc"
