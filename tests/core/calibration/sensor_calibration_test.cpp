// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_calibration.h"
#include "core/calibration/sensor_correction.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// Weights on a force sensor: up and down, twice, 0 to 50 N; its readings are 1.5 % too high and slightly
/// bent.
double trueReading(double load_N)
{
    return 0.3 + 1.015 * load_N + 2e-4 * load_N * load_N;
}
constexpr double noise_N = 0.02;

SensorCalibration weights(GaussianNoise& noise, const CalibrationReference& reference = {},
                          double referenceError = 0)
{
    SensorCalibration calibration;
    calibration.unit = u"N"_s;
    calibration.degree = 2;
    calibration.reference = reference;
    for (int run = 0; run < 2; ++run)
        for (int i = 0; i <= 20; ++i) {
            const double stated = 5.0 * (i <= 10 ? i : 20 - i);
            const double load = stated * (1 + referenceError);
            calibration.points.push_back({stated, trueReading(load) + noise_N * noise()});
        }
    return calibration;
}

} // namespace

class SensorCalibrationTest : public QObject {
    Q_OBJECT
private slots:
    void theExpandedUncertaintyHoldsTheLoadInNineteenOfTwenty()
    {
        GaussianNoise noise(11);
        int held = 0, tried = 0;
        for (int run = 0; run < 500; ++run) {
            CalibrationReference reference;
            reference.relativeUncertainty = 5e-4;
            const SensorCalibration calibration = weights(noise, reference, 5e-4 * noise());
            const CalibrationEvaluation found = evaluateCalibration(calibration).value();
            const SensorCorrection correction(found.curve);
            for (const double load : {2.0, 24.0, 49.0}) {
                const double seen = correction.loadOf(trueReading(load) + noise_N * noise());
                held += std::abs(seen - load) <= expandedUncertaintyAt(found, reference, load) ? 1 : 0;
                ++tried;
            }
        }
        // The zero's return is counted on top of the scatter that causes it, so it may hold more. The three
        // loads of a calibration share its error: 500 independent ones allow +- 3 sqrt(.05 .95 / 500) = 2.9
        // %.
        const double share = double(held) / tried;
        QVERIFY2(share > 0.921 && share < 0.985, qPrintable(QString::number(share)));
    }

    void theScalesUncertaintyIsThatOfItsSlope()
    {
        GaussianNoise noise(5);
        double squares = 0, stated = 0;
        constexpr int runs = 400;
        const double truth = (trueReading(50) - trueReading(0)) / 50;
        for (int run = 0; run < runs; ++run) {
            const CalibrationEvaluation found = evaluateCalibration(weights(noise)).value();
            const double slope = (found.curve.readingAt(50) - found.curve.readingAt(0)) / 50;
            squares += std::pow(slope / truth - 1, 2) / runs;
            stated += found.scaleUncertainty / runs;
        }
        // Ends of a curve are anticorrelated, so their sum in quadrature states no less than the truth; a
        // standard deviation from 400 runs is known to 3.5 %.
        const double ratio = stated / std::sqrt(squares);
        QVERIFY2(ratio > 0.85 && ratio < 1.2, qPrintable(QString::number(ratio)));
    }

    void residualsAndFiguresBelongToThePoints()
    {
        GaussianNoise noise(3);
        const SensorCalibration calibration = weights(noise);
        const CalibrationEvaluation found = evaluateCalibration(calibration).value();
        QCOMPARE(found.residuals.size(), calibration.points.size());
        double squares = 0;
        for (const double residual : found.residuals)
            squares += residual * residual;
        QVERIFY(
            std::abs(std::sqrt(squares / found.curve.degreesOfFreedom()) / found.curve.residualDeviation() -
                     1) < 1e-9);
        QVERIFY(found.figures.reversibilityPercent && found.figures.zeroReturnPercent);
    }

    void aBetterReferenceNarrowsIt()
    {
        GaussianNoise first(7), second(7);
        CalibrationReference coarse;
        coarse.standardUncertainty = 0.05;
        const double fine = evaluateCalibration(weights(first)).value().expandedUncertainty;
        const double wide = evaluateCalibration(weights(second, coarse)).value().expandedUncertainty;
        QVERIFY(wide > fine);
        QVERIFY(std::abs(wide - std::hypot(fine, 1.96 * 0.05)) < 0.02 * wide);
    }

    void whatCannotBeUsedIsRefusedWithAReason_data()
    {
        QTest::addColumn<int>("degree");
        QTest::addColumn<double>("uncertainty");
        QTest::addColumn<QString>("word");
        QTest::newRow("a negative uncertainty") << 1 << -0.1 << u"uncertainty"_s;
        QTest::newRow("too high a degree") << 12 << 0.0 << u"degree"_s;
    }
    void whatCannotBeUsedIsRefusedWithAReason()
    {
        QFETCH(int, degree);
        QFETCH(double, uncertainty);
        QFETCH(QString, word);
        GaussianNoise noise(1);
        SensorCalibration calibration = weights(noise);
        calibration.degree = degree;
        calibration.reference.standardUncertainty = uncertainty;
        const auto found = evaluateCalibration(calibration);
        QVERIFY(!found);
        QVERIFY2(found.error().describe().contains(word), qPrintable(found.error().describe()));
    }

    void aCurveThatEndsLevelIsRefused()
    {
        SensorCalibration calibration;
        calibration.degree = 2;
        for (int i = 0; i <= 10; ++i)
            calibration.points.push_back({double(i), 20.0 * i - i * i}); // level at 10
        QVERIFY(!evaluateCalibration(calibration));
    }

    void loadsFromReadingsAreTheCurveTurnedRound_data()
    {
        QTest::addColumn<int>("degree");
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("start");
        for (const int degree : {1, 2, 3, 5})
            for (const double scale : {1e-6, 1.0, -3e6})
                for (const double start : {0.0, 1e4})
                    QTest::addRow("degree %d, scale %g, from %g", degree, scale, start)
                        << degree << scale << start;
    }
    void loadsFromReadingsAreTheCurveTurnedRound()
    {
        QFETCH(int, degree);
        QFETCH(double, scale);
        QFETCH(double, start);
        std::vector<CalibrationPoint> points;
        for (int i = 0; i <= 20; ++i) {
            const double z = i / 10.0 - 1;
            points.push_back({start + 50.0 * i, scale * (z + 0.2 * z * z - 0.05 * std::pow(z, degree))});
        }
        const CalibrationCurve curve = CalibrationCurve::fit(points, degree).value();
        const SensorCorrection correction(curve);
        for (int i = -10; i <= 110; ++i) {
            const double load = start + 10.0 * i;
            const double back = correction.loadOf(correction.readingOf(load));
            QVERIFY2(std::abs(back - load) < 1e-10 * 1000 + 1e-14 * std::abs(load),
                     qPrintable(u"%1 became %2"_s.arg(load).arg(back)));
            const auto again = SensorCorrection::fromText(correction.text());
            QVERIFY(again && again->loadOf(correction.readingOf(load)) == back);
            const auto exact = curve.loadAt(correction.readingOf(load));
            if (i > 0 && i < 100)
                QVERIFY(exact && std::abs(exact->load - back) < 1e-9 * 1000);
        }
    }

    void aTextThatIsNoCorrectionIsNone()
    {
        for (const QString& text : {u""_s, u"0 1"_s, u"0 1 2"_s, u"0 1 2 x"_s, u"0 0 1 2"_s, u"0 -1 1 2"_s,
                                    u"0 1 5 0"_s, u"0 1 0 nan"_s, u"1 2 3 4 5 6 7 8 9 10 11 12"_s})
            QVERIFY2(!SensorCorrection::fromText(text), qPrintable(text));
        QVERIFY(SensorCorrection::fromText(u"0 1 5 2"_s));
    }

    void whatIsDueIsToldBeforehand()
    {
        const QDate today(2026, 3, 1);
        QVERIFY(calibrationStatus(std::nullopt, today) == CalibrationStatus::Missing);
        QVERIFY(calibrationStatus(today, today) == CalibrationStatus::DueSoon);
        QVERIFY(calibrationStatus(today.addDays(-1), today) == CalibrationStatus::Overdue);
        QVERIFY(calibrationStatus(today.addDays(dueSoonDays), today) == CalibrationStatus::DueSoon);
        QVERIFY(calibrationStatus(today.addDays(dueSoonDays + 1), today) == CalibrationStatus::Valid);
    }
};

GRIPSCOPE_TEST(SensorCalibrationTest)
#include "sensor_calibration_test.moc"
