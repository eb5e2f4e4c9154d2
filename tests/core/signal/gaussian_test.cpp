// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

class GaussianTest : public QObject {
    Q_OBJECT
private slots:
    void theSeedAloneDecides()
    {
        GaussianNoise a(7);
        GaussianNoise b(7);
        GaussianNoise c(8);
        bool differs = false;
        for (int i = 0; i < 100; ++i) {
            const double value = a();
            QCOMPARE(value, b());
            differs = differs || value != c();
        }
        QVERIFY(differs);
    }
    void momentsAreThoseOfTheStandardNormal()
    {
        // 1e5 draws: standard deviations of the four moments are 0.0032, 0.0045, 0.012, 0.031; five of each.
        GaussianNoise noise(1);
        constexpr int count = 100000;
        double sums[4] = {};
        for (int i = 0; i < count; ++i) {
            const double x = noise();
            sums[0] += x;
            sums[1] += x * x;
            sums[2] += x * x * x;
            sums[3] += x * x * x * x;
        }
        QVERIFY(std::abs(sums[0] / count) < 0.016);
        QVERIFY(std::abs(sums[1] / count - 1) < 0.023);
        QVERIFY(std::abs(sums[2] / count) < 0.061);
        QVERIFY(std::abs(sums[3] / count - 3) < 0.155);
    }
    void tailsAreThoseOfTheStandardNormal()
    {
        // Beyond 1.96: 5 %, standard deviation 69 of 1e5; beyond 3.29: 0.1 %, standard deviation 10.
        GaussianNoise noise(2);
        int beyond2 = 0;
        int beyond3 = 0;
        for (int i = 0; i < 100000; ++i) {
            const double x = std::abs(noise());
            beyond2 += x > 1.959964 ? 1 : 0;
            beyond3 += x > 3.290527 ? 1 : 0;
        }
        QVERIFY(std::abs(beyond2 - 5000) < 345);
        QVERIFY(std::abs(beyond3 - 100) < 50);
    }
    void successiveNumbersAreIndependent()
    {
        GaussianNoise noise(3);
        double previous = noise();
        double sum = 0;
        for (int i = 0; i < 100000; ++i) {
            const double next = noise();
            sum += previous * next;
            previous = next;
        }
        QVERIFY(std::abs(sum / 100000) < 0.016);
    }
    void uniformStaysInItsInterval()
    {
        GaussianNoise noise(4);
        double sum = 0;
        for (int i = 0; i < 100000; ++i) {
            const double u = noise.uniform();
            QVERIFY(u >= 0 && u < 1);
            sum += u;
        }
        QVERIFY(std::abs(sum / 100000 - 0.5) < 0.0046); // five standard deviations
    }
};

GRIPSCOPE_TEST(GaussianTest)
#include "gaussian_test.moc"
