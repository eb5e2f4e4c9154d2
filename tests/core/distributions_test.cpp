// SPDX-License-Identifier: GPL-3.0-or-later
// Each distribution where its law has a closed form. Boost.Math states errors of a few hundred roundings, so
// 1e-12.
#include "core/math/distributions.h"
#include "core/math/normal_interval.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;

namespace {

constexpr double closedFormTolerance = 1e-12;

bool matchesLaw(double found, double expected)
{
    return std::abs(found - expected) <= closedFormTolerance * std::abs(expected);
}

} // namespace

class DistributionsTest : public QObject {
    Q_OBJECT
private slots:
    void theNormalQuantileInvertsTheErrorFunction()
    {
        for (const double x : {-3.0, -1.0, 0.5, normal95, 5.0}) {
            QVERIFY(matchesLaw(normalQuantileAbove(normalBelow(-x)), x));
            QVERIFY(std::abs(normalQuantile(normalBelow(x)) - x) < 1e-9); // 1 - 3e-7 has lost digits
        }
    }
    void studentWithOneDegreeIsCauchy()
    {
        for (const double t : {0.1, 1.0, 12.7, 1000.0}) {
            const double above = std::atan(1 / t) / std::numbers::pi;
            QVERIFY(matchesLaw(studentAbove(t, 1), above));
            QVERIFY(matchesLaw(studentQuantileAbove(above, 1), t));
            QVERIFY(std::abs(studentQuantile(1 - above, 1) / t - 1) < 1e-9); // 1 - above is rounded
        }
    }
    void chiSquaredWithTwoDegreesIsExponential()
    {
        for (const double x : {0.01, 1.0, 5.99, 80.0}) {
            QVERIFY(matchesLaw(chiSquaredAbove(x, 2), std::exp(-x / 2)));
            QVERIFY(matchesLaw(chiSquaredBelow(x, 2), -std::expm1(-x / 2)));
            QVERIFY(matchesLaw(chiSquaredQuantileAbove(std::exp(-x / 2), 2), x));
        }
        QVERIFY(matchesLaw(chiSquaredQuantile(0.95, 2), -2 * std::log(0.05)));
    }
    /// The Poisson mixture that defines it: sum over j of Poisson(j; shift / 2) P(chi^2 of p + 2 j <= x).
    void shiftedSquaresAreAMixtureOfChiSquares()
    {
        for (const double p : {1.0, 2.0, 3.0, 4.0})
            for (const double d : {1e-5, 1e-3, 0.3, 1.0, 4.0, 9.0})
                for (const double x : {1e-3, 0.5, 3.0, 20.0, 120.0}) {
                    double expected = 0;
                    for (int j = 0; j < 250; ++j) {
                        const double weight =
                            std::exp(j * std::log(d * d / 2) - d * d / 2 - logGamma(j + 1.0));
                        expected += weight * chiSquaredBelow(x, p + 2 * j);
                    }
                    const double found = nonCentralChiSquaredBelow(x, p, d * d);
                    QVERIFY2(std::abs(found - expected) < 1e-13 + 1e-10 * expected,
                             qPrintable(QStringLiteral("p %1, d %2, x %3: %4, %5")
                                            .arg(p)
                                            .arg(d)
                                            .arg(x)
                                            .arg(found, 0, 'g', 15)
                                            .arg(expected, 0, 'g', 15)));
                }
    }
    /// With two degrees of freedom the integral over chi is done by parts, a = t / sqrt(2).
    void aShiftedStudentWithTwoDegreesIsClosed()
    {
        for (const double d : {-2.0, 0.0, 0.7, 3.0, 20.0})
            for (const double t : {-3.0, 0.5, 2.0, 25.0}) {
                const double a = t / std::sqrt(2), b = std::sqrt(1 + a * a);
                const double expected =
                    normalBelow(-d) + a / b * std::exp(-d * d / (2 * b * b)) * normalBelow(a * d / b);
                QVERIFY(std::abs(nonCentralStudentBelow(t, 2, d) - expected) < 1e-10);
            }
        QVERIFY(matchesLaw(normalAbove(1.3), normalBelow(-1.3)));
    }
    void fisherWithTwoInTheNumeratorIsAPower()
    {
        for (const double n : {3.0, 10.0, 197.0})
            for (const double f : {0.2, 1.0, 7.5}) {
                const double above = std::pow(1 + 2 * f / n, -n / 2);
                QVERIFY(matchesLaw(fisherAbove(f, 2, n), above));
                QVERIFY(std::abs(fisherQuantileAbove(above, 2, n) / f - 1) < 1e-10);
                QVERIFY(std::abs(fisherQuantile(1 - above, 2, n) / f - 1) < 1e-9);
            }
    }
    /// P = x^a exp(-(1 - x) shift / 2) for two squares below, where x = a f / (a f + 1), a = numerator / 2:
    /// the Poisson mixture of incomplete beta functions, each a power there.
    void aShiftedFisherWithTwoInTheDenominatorIsClosed()
    {
        for (const double numerator : {2.0, 3.0, 8.0})
            for (const double shift : {0.5, 4.0, 16.0}) {
                const double a = numerator / 2, f = 1.7, x = a * f / (a * f + 1);
                const double expected = std::pow(x, a) * std::exp(-(1 - x) * shift / 2);
                QVERIFY(std::abs(nonCentralFisherBelow(f, numerator, 2, shift) / expected - 1) < 1e-10);
            }
    }
    void gammaBetaAndTheGammaFunction()
    {
        QVERIFY(matchesLaw(gammaAbove(3, 1, 2), std::exp(-1.5)));
        QVERIFY(matchesLaw(betaQuantile(0.3, 1, 4), 1 - std::pow(0.7, 0.25)));
        QVERIFY(matchesLaw(betaQuantile(0.3, 5, 1), std::pow(0.3, 0.2)));
        double factorial = 1;
        for (int n = 2; n < 20; ++n) {
            factorial *= n;
            QVERIFY(matchesLaw(logGamma(n + 1), std::log(factorial)));
        }
        QVERIFY(matchesLaw(logGamma(0.5), std::log(std::numbers::pi) / 2));
    }
    void nothingIsThrownWhereANumberIsTooLarge()
    {
        QVERIFY(std::isinf(fisherQuantileAbove(1e-300, 3, 0.01)));
        QCOMPARE(fisherAbove(1e308, 3, 5) < 1e-300, true);
    }
};

GRIPSCOPE_TEST(DistributionsTest)
#include "distributions_test.moc"
