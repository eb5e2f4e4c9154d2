// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_curve.h"
#include "core/calibration/calibration_figures.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// Load cell calibration of P. Pontius (NIST, about 1975; Statistical Reference Datasets, "Pontius"): 150,000
/// to 3,000,000, twice.
std::vector<CalibrationPoint> loadCell()
{
    constexpr double first[] = {.11019,  .21956,  .32949,  .43899,  .54803,  .65694,  .76562,
                                .87487,  .98292,  1.09146, 1.20001, 1.30822, 1.41599, 1.52399,
                                1.63194, 1.73947, 1.84646, 1.95392, 2.06128, 2.16844};
    constexpr double second[] = {.11052,  .22018,  .32939,  .43886,  .54798,  .65739,  .76596,
                                 .87474,  .98300,  1.09150, 1.20004, 1.30818, 1.41613, 1.52408,
                                 1.63159, 1.73965, 1.84696, 1.95445, 2.06177, 2.16829};
    std::vector<CalibrationPoint> points;
    for (const auto& readings : {first, second})
        for (int i = 0; i < 20; ++i)
            points.push_back({150'000.0 * (i + 1), readings[i]});
    return points;
}

bool agree(double found, double wanted, double relative)
{
    return std::abs(found / wanted - 1) < relative;
}

/// 0 to 1 and back in tenths on a known curve.
std::vector<CalibrationPoint> upAndDown(double hysteresis, double noise, std::uint64_t seed)
{
    GaussianNoise draw(seed);
    std::vector<CalibrationPoint> points;
    for (int run = 0; run < 3; ++run)
        for (int i = 0; i <= 20; ++i) {
            const double load = (i <= 10 ? i : 20 - i) / 10.0;
            const double sag = i > 10 ? hysteresis * load * (1 - load) * 4 : 0;
            points.push_back({load, 1 + 2 * load + sag + noise * draw()});
        }
    return points;
}

} // namespace

class CalibrationCurveTest : public QObject {
    Q_OBJECT
private slots:
    void theLoadCellsCertifiedValuesAreReached()
    {
        // Certified to 15 digits, and confirmed in rational arithmetic. Ten are asked for here.
        const CalibrationCurve curve = CalibrationCurve::fit(loadCell(), 2).value();
        const double coefficients[] = {0.673565789473684e-3, 0.732059160401003e-6, -0.316081871345029e-14};
        const double deviations[] = {0.107938612033077e-3, 0.157817399981659e-9, 0.486652849992036e-16};
        for (int i = 0; i < 3; ++i) {
            QVERIFY(agree(curve.coefficients()(i), coefficients[i], 1e-12));
            QVERIFY(agree(curve.standardDeviations()(i), deviations[i], 1e-12));
        }
        QVERIFY(agree(curve.residualDeviation(), 0.205177424076185e-3, 1e-12));
        QCOMPARE(curve.degreesOfFreedom(), 37);
    }
    void badlyScaledPointsAgreeWithRationalArithmetic()
    {
        // Loads over seven decades with no pattern, their squares up to 1e13. The wanted numbers are the
        // normal equations of these very doubles, solved in fractions.
        const std::vector<CalibrationPoint> points{
            {0, 0.0011},          {1, 0.0011009},    {10, 0.00111},      {100, 0.00117},
            {1000, 0.0018},       {30000, 0.0221},   {250000.5, 0.1769}, {1000000, 0.7017},
            {1700000.25, 1.1904}, {2500000, 1.7481}, {2999999, 2.0951},  {3000000, 2.0957}};
        const CalibrationCurve curve = CalibrationCurve::fit(points, 2).value();
        const double coefficients[] = {1.14041009637608832e-3, 7.01786609421355951e-7,
                                       -1.23012869282317608e-15};
        const double deviations[] = {8.58609526192207778e-5, 2.37441383746174876e-10,
                                     8.20684431767793296e-17};
        for (int i = 0; i < 3; ++i) {
            QVERIFY(agree(curve.coefficients()(i), coefficients[i], 1e-12));
            QVERIFY(agree(curve.standardDeviations()(i), deviations[i], 1e-12));
        }
        QVERIFY(agree(curve.residualDeviation(), 2.19127802182072643e-4, 1e-12));
    }
    void loadsFarFromZeroCostNoDigits()
    {
        // Exactly on a cubic with integer coefficients in (load - 1e7), whose powers of the load are exact.
        std::vector<CalibrationPoint> points;
        for (int i = -10; i <= 10; ++i)
            points.push_back({1e7 + i, 7.0 + 3000.0 * i + 2.0 * i * i + i * i * i});
        const CalibrationCurve curve = CalibrationCurve::fit(points, 3).value();
        QVERIFY(agree(curve.coefficients()(3), 1, 1e-9));
        QVERIFY(agree(curve.readingAt(1e7 + 4.5), 7 + 13500 + 40.5 + 91.125, 1e-12));
        QVERIFY(agree(curve.loadAt(7 + 13500 + 40.5 + 91.125)->load, 1e7 + 4.5, 1e-15));
    }
    void thereAndBackIsTheSameLoad()
    {
        const CalibrationCurve curve = CalibrationCurve::fit(loadCell(), 2).value();
        for (double load = curve.leastLoad(); load <= curve.largestLoad(); load += 14'250) {
            const auto back = curve.loadAt(curve.readingAt(load));
            QVERIFY2(back && agree(back->load, load, 1e-12), qPrintable(QString::number(load)));
        }
        QVERIFY(curve.loadAt(curve.readingAt(curve.largestLoad())));
        QVERIFY(!curve.loadAt(2.3));
        QVERIFY(!curve.loadAt(0.0));
        QVERIFY(!curve.loadAt(std::numeric_limits<double>::quiet_NaN()));
    }
    void theUncertaintyOfALoadHoldsIt()
    {
        // Intervals of two standard uncertainties, Student with 30 degrees: 94.5 %. 2,000 draws have a
        // standard deviation of 0.5 %.
        GaussianNoise draw(8);
        int held = 0;
        constexpr int runs = 2000;
        for (int run = 0; run < runs; ++run) {
            std::vector<CalibrationPoint> points;
            for (int i = 0; i < 33; ++i) {
                const double load = i / 32.0;
                points.push_back({load, 1 + 2 * load + 0.3 * load * load + 0.01 * draw()});
            }
            const CalibrationCurve curve = CalibrationCurve::fit(points, 2).value();
            const auto found = curve.loadAt(1 + 2 * 0.4 + 0.3 * 0.16 + 0.01 * draw());
            held += found && std::abs(found->load - 0.4) < 2 * found->standardUncertainty ? 1 : 0;
        }
        QVERIFY2(std::abs(held / double(runs) - 0.945) < 0.02, qPrintable(QString::number(held)));
    }
    void whatCannotBeFittedSaysWhatIsMissing_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<int>("degree");
        QTest::addColumn<QString>("words");
        QTest::newRow("nothing") << 0 << 1 << u"0 points"_s;
        QTest::newRow("too few") << 3 << 2 << u"at least 4 points"_s;
        QTest::newRow("degree 0") << 9 << 0 << u"degree"_s;
        QTest::newRow("degree 9") << 50 << 9 << u"degree"_s;
    }
    void whatCannotBeFittedSaysWhatIsMissing()
    {
        QFETCH(int, points);
        QFETCH(int, degree);
        QFETCH(QString, words);
        std::vector<CalibrationPoint> all;
        for (int i = 0; i < points; ++i)
            all.push_back({double(i), 2.0 * i});
        const auto fitted = CalibrationCurve::fit(all, degree);
        QVERIFY(!fitted);
        QCOMPARE(fitted.error().code, ErrorCode::BadInput);
        QVERIFY2(fitted.error().describe().contains(words), qPrintable(fitted.error().describe()));
    }
    void pointsThatTellNoCurveAreRefused()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!CalibrationCurve::fit({{1, 1}, {1, 2}, {1, 3}, {1, 4}}, 1)); // one load only
        QVERIFY(!CalibrationCurve::fit({{0, 1}, {1, nan}, {2, 3}, {3, 4}}, 1));
        QVERIFY(!CalibrationCurve::fit({{0, 1}, {1, 1}, {2, 1}, {3, 1}}, 1));  // no slope
        QVERIFY(!CalibrationCurve::fit({{0, 0}, {1, 3}, {2, 4}, {3, 3}}, 2));  // two loads for one reading
        QVERIFY(!CalibrationCurve::fit({{-1e308, 0}, {0, 1}, {1e308, 2}}, 1)); // a range beyond the numbers
        const auto tiny = CalibrationCurve::fit({{0, 0}, {1e-300, 1}, {2e-300, 2}, {3e-300, 3}}, 2);
        QVERIFY(!tiny || tiny->coefficients().allFinite());
    }
    void reversibilityAndRepeatabilityAreToldApart()
    {
        const auto points = upAndDown(0.02, 0.001, 5);
        const CalibrationFigures figures =
            calibrationFigures(CalibrationCurve::fit(points, 1).value(), points);
        // Full scale 2: a sag of 0.02 is 1 %; each mean of three has an error of 0.03 %.
        QVERIFY(std::abs(*figures.reversibilityPercent - 1) < 0.15);
        QVERIFY(agree(*figures.repeatability, 0.001, 0.35)); // four standard errors with 44 degrees
        QCOMPARE(figures.repeatabilityDegreesOfFreedom, 63 - 11 - 10);
        QVERIFY(figures.zeroReturnPercent && std::abs(*figures.zeroReturnPercent) < 0.3);
    }
    void aCurveIsNoLine()
    {
        // reading = load + load^2 / 2 over [0, 1]: off the line through its ends by 1/8 at the middle,
        // of 1.5.
        std::vector<CalibrationPoint> points;
        for (int i = 0; i <= 10; ++i)
            points.push_back({i / 10.0, i / 10.0 + i * i / 200.0});
        const CalibrationFigures figures =
            calibrationFigures(CalibrationCurve::fit(points, 2).value(), points);
        QVERIFY(std::abs(figures.linearityPercent - 100 / 8.0 / 1.5) < 1e-9);
        QVERIFY(!figures.repeatability && !figures.reversibilityPercent && !figures.lackOfFitProbability);
        QVERIFY(!figures.zeroReturnPercent);
    }
    void lackOfFitAsksForAHigherDegree()
    {
        const auto points = loadCell();
        const auto probability = [&points](int degree) {
            return *calibrationFigures(CalibrationCurve::fit(points, degree).value(), points)
                        .lackOfFitProbability;
        };
        QVERIFY(probability(1) < 1e-6);
        QVERIFY(probability(2) > 0.01);
    }
    void rootsOfAPolynomialAreFound()
    {
        // (x - 1)(x - 2)(x - 3) and (x - 2)^2
        const std::vector<long double> cubic{-6, 11, -6, 1};
        const auto roots = polynomialRoots(cubic, 0, 10);
        QCOMPARE(roots.size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::abs(roots[i] - static_cast<long double>(i + 1)) < 1e-15L);
        QCOMPARE(polynomialRoots(cubic, 1.5L, 2.5L).size(), std::size_t(1));
        QVERIFY(polynomialRoots(cubic, 3.5L, 9).empty());
        QCOMPARE(polynomialRoots(std::vector<long double>{4, -4, 1}, 0, 5).size(), std::size_t(1));
        QVERIFY(polynomialRoots(std::vector<long double>{0, 0, 0}, 0, 1).size() < 4);
    }
};

GRIPSCOPE_TEST(CalibrationCurveTest)
#include "calibration_curve_test.moc"
